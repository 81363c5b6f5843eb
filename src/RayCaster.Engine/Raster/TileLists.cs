namespace RayCaster.Engine;

/// <summary>Triangles with the tiles in which they may show; each thread fills its own.</summary>
internal sealed class TileLists(int width)
{
    private readonly int tilesAcross = Tile.TilesOf(width);

    public PooledList<(int Bin, TriangleCluster Cluster)> Items { get; } = new();

    /// <summary>In how many tiles the pixels of a rectangle lie.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static long TilesOf(uint left, uint right, uint bottom, uint top) => Tiles(left, right) * Tiles(bottom, top);

    /// <param name="maxInverseDepth">The greatest inverse depth of a sample that they cover.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(TriangleRun run, float maxInverseDepth, uint left, uint right, uint bottom, uint top)
    {
        if (((left ^ right) | (bottom ^ top)) >= Tile.MaxSide) AddToTiles(run, maxInverseDepth, left, right, bottom, top);
        else Items.Add((TileOf(left / Tile.MaxSide, bottom / Tile.MaxSide), new(run, maxInverseDepth, Cells.Of(left, right, bottom, top))));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void AddToTiles(TriangleRun run, float maxInverseDepth, uint left, uint right, uint bottom, uint top)
    {
        for (var y = bottom / Tile.MaxSide; y <= top / Tile.MaxSide; y++)
        {
            for (var x = left / Tile.MaxSide; x <= right / Tile.MaxSide; x++)
            {
                var (column, row) = (x * Tile.MaxSide, y * Tile.MaxSide);
                const uint Last = Tile.MaxSide - 1;
                var cells = Cells.Of(Math.Max(left, column), Math.Min(right, column + Last), Math.Max(bottom, row), Math.Min(top, row + Last));
                Items.Add((TileOf(x, y), new(run, maxInverseDepth, cells)));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int TileOf(uint tileX, uint tileY) => (int)tileY * tilesAcross + (int)tileX;

    private static long Tiles(uint first, uint last) => last / Tile.MaxSide - first / Tile.MaxSide + 1L;
}
