namespace RayCaster.Engine;

/// <summary>A part of the picture in which members of a batch are looked for: its rays, the nearest hits so far, and what they hide. Each thread has
/// its own.</summary>
/// <remarks>Most members are hidden, wholly or in part, and branch prediction cannot tell where. So the packets that a member's formula must test
/// are listed first, without branches, and then computed without any.</remarks>
internal sealed class BatchTile<N>(Camera camera) where N : struct, IPacket<N>
{
    private const int Side = ScreenBins.PartSide;

    private const int CellSide = 8, CellsAcross = Side / CellSide, Cells = CellsAcross * CellsAcross;

    private readonly int[] packets = new int[Side * Side / N.Count];
    private readonly double[] farthest = new double[Cells]; // the greatest t of the nearest hits in each cell
    private PixelRect tile;
    private uint touched; // the cells whose farthest hit may have changed

    public RayStream Rays { get; } = new(camera, Side * Side);

    public void Begin(in PixelRect tile)
    {
        touched = (1u << Cells) - 1; // until Refresh, nothing is known of any cell
        this.tile = tile;
        Rays.Begin<N>(tile.Column, tile.Width, Side);
        Rays.Aim<N>(tile.Row, tile.Height);
        for (var i = 0; i < Side; i++) // what lies beyond the picture is hidden
        {
            var width = i < tile.Height ? tile.Width : 0;
            if (width < Side) Rays.Hide(i * Side + width, Side - width);
        }
    }

    public void CopyHits(RayStream rays)
    {
        var row = (rays.Row - tile.Row) * Side;
        for (var i = 0; i < tile.Width; i += N.Count) Rays.Set(row + i, rays.NearestAt<N>(i), rays.ModelsAt<N>(i));
        if (tile.Width < Side) Rays.Hide(row + tile.Width, Side - tile.Width);
    }

    /// <summary>Whether all pixels have a hit nearer than this.</summary>
    public bool Hides(double nearest) => Visible(nearest) == 0;

    /// <summary>Finds the farthest hit of each cell that a member may have changed.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void Refresh()
    {
        for (; touched != 0; touched &= touched - 1) FindFarthest(BitOperations.TrailingZeroCount(touched));
    }

    /// <summary>Lists the packets in a member's rectangle that do not hide it, by their first pixels.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public ReadOnlySpan<int> List(in BatchItem member)
    {
        var nearest = member.Nearest;
        ref readonly var rect = ref member.ShowsIn;
        var (left, right) = (Math.Max(rect.Column - tile.Column, 0), Math.Min(rect.EndColumn - tile.Column, tile.Width) - 1);
        var (bottom, top) = (Math.Max(rect.Row - tile.Row, 0), Math.Min(rect.EndRow - tile.Row, tile.Height) - 1);
        var columns = (2u << (right / CellSide)) - (1u << (left / CellSide)); // a bit for each cell
        var rows = (uint)((2UL << top) - (1UL << bottom));                      // a bit for each row
        var inRows = (2u << (top / CellSide)) - (1u << (bottom / CellSide));
        // A cell is a bit: four for each row of cells. 0x1111 keeps the first bit of each row of cells; times columns, each row has these columns.
        var cells = columns * ((inRows | inRows << 3 | inRows << 6 | inRows << 9) & 0x1111) & Visible(nearest);
        touched |= cells;
        var least = Lanes.Broadcast<N>(nearest);
        var (rays, packets, end) = (Rays, this.packets, 0);
        for (; cells != 0; cells &= cells - 1)
        {
            var cell = BitOperations.TrailingZeroCount(cells);
            var i = Corner(cell);
            var inCell = rows >> (cell / CellsAcross * CellSide);
            for (var y = 0; y < CellSide; y++, i += Side, inCell >>= 1)
            {
                for (var x = 0; x < CellSide; x += N.Count)
                {
                    packets[end] = i + x;
                    end += (Lanes.All(rays.NearestAt<N>(i + x) < least) ? 0 : 1) & (int)inCell;
                }
            }
        }
        return packets.AsSpan(0, end);
    }

    /// <summary>A bit for each cell in which some pixel's nearest hit is not nearer than this.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint Visible(double nearest)
    {
        var least = Lanes.Broadcast<N>(nearest);
        var bits = 0u;
        for (var i = 0; i < Cells; i += N.Count) bits |= N.Bits(N.Load(farthest, i) >= least) << i;
        return bits;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void FindFarthest(int cell)
    {
        var i = Corner(cell);
        var most = Rays.NearestAt<N>(i);
        for (var x = 0; x < CellSide; x += N.Count)
            for (var y = 0; y < CellSide * Side; y += Side)
                most = N.Max(most, Rays.NearestAt<N>(i + x + y));
        farthest[cell] = N.Greatest(most);
    }

    /// <summary>The first pixel of a cell.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int Corner(int cell) => cell / CellsAcross * CellSide * Side + cell % CellsAcross * CellSide;
}
