namespace RayCaster.Engine;

/// <summary>
/// Finds the members that may show in a part of the picture. There are several grids, each of bins four times as wide and high as the one before,
/// and a member lies in the finest one whose bins are not smaller than its rectangle, in the bin of the rectangle's lower left corner. So what
/// shows in a part has its corner in the part's bin, or in the one to the left, below, or both; and each member has one place, however large it is.
/// </summary>
/// <remarks>Members that show near each other are also neighbours in memory; in the scene's order, a part would wait for each of them.</remarks>
internal sealed class ScreenBins
{
    /// <summary>The most columns and rows of a part in which members are looked for. Its rays and hits, 48 bytes a pixel, should stay in the
    /// first-level cache.</summary>
    public const int PartSide = 32;

    private readonly Level[] levels;

    public ScreenBins(Camera camera)
    {
        List<Level> created = [];
        var first = 0;
        var side = BitOperations.Log2(PartSide);
        do
        {
            var level = new Level(first, side, (camera.Width - 1 >> side) + 1, (camera.Height - 1 >> side) + 1);
            created.Add(level);
            first += level.Across * level.Up;
            side += 2;
        }
        while (created[^1].Across > 1 || created[^1].Up > 1);
        levels = [.. created];
    }

    /// <summary>Finds ranges that hold all members that may show in a tile, and others.</summary>
    public void Find(in PixelRect tile, Bins<BatchItem> members, PooledList<(int First, int End)> ranges)
    {
        ranges.Clear();
        foreach (ref readonly var level in levels.AsSpan())
        {
            var (left, right) = (Math.Max((tile.Column >> level.Side) - 1, 0), tile.EndColumn - 1 >> level.Side);
            var (bottom, top) = (Math.Max((tile.Row >> level.Side) - 1, 0), tile.EndRow - 1 >> level.Side);
            for (var y = bottom; y <= top; y++)
            {
                var row = level.First + y * level.Across;
                var (first, end) = (members.StartOf(row + left), members.StartOf(row + right + 1));
                if (first < end) ranges.Add((first, end));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int BinOf(in PixelRect rect)
    {
        var size = Math.Max(rect.Width, rect.Height);
        ref readonly var level = ref levels[size <= PartSide ? 0 : BitOperations.Log2((uint)(size - 1) / PartSide) / 2 + 1];
        return level.First + (rect.Row >> level.Side) * level.Across + (rect.Column >> level.Side);
    }

    /// <param name="Side">The logarithm of a bin's side in pixels.</param>
    private readonly record struct Level(int First, int Side, int Across, int Up);
}
