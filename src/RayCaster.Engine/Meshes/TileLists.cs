using System.Runtime.CompilerServices;

namespace RayCaster.Engine;

/// <summary>Triangles or clusters with the tiles in which they may show; each thread fills its own.</summary>
internal sealed class TileLists(int width)
{
    private readonly int tilesAcross = Tile.TilesOf(width);
    private (uint Left, uint Right, uint Bottom, uint Top) extent = (int.MaxValue, 0, int.MaxValue, 0);

    /// <summary>Two places for each tile, one for each side of a triangle.</summary>
    public PooledList<(int Place, TriangleCluster Cluster)> Items { get; } = new();

    /// <summary>The pixels that may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent => ((int)extent.Left, (int)extent.Right, (int)extent.Bottom, (int)extent.Top);

    /// <summary>In how many tiles the pixels of a rectangle lie.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static long TilesOf(uint left, uint right, uint bottom, uint top) => Tiles(left, right) * Tiles(bottom, top);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Extend(uint left, uint right, uint bottom, uint top)
    {
        if (left < extent.Left) extent.Left = left;
        if (right > extent.Right) extent.Right = right;
        if (bottom < extent.Bottom) extent.Bottom = bottom;
        if (top > extent.Top) extent.Top = top;
    }

    /// <summary>Adds what shows in a rectangle of pixels.</summary>
    /// <param name="first">The first of the triangles, or the only one.</param>
    /// <param name="mostW">The greatest w of a sample that they cover.</param>
    /// <param name="side">Whether they are seen the one way around (0) or the other (1).</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Add(int first, float mostW, int side, uint left, uint right, uint bottom, uint top)
    {
        Extend(left, right, bottom, top);
        if (((left ^ right) | (bottom ^ top)) >= Tile.MaxSide) AddToTiles(first, mostW, side, left, right, bottom, top);
        else Items.Add((PlaceOf(left / Tile.MaxSide, bottom / Tile.MaxSide, side), new(first, mostW, Cells.Of(left, right, bottom, top))));
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private void AddToTiles(int first, float mostW, int side, uint left, uint right, uint bottom, uint top)
    {
        for (var y = bottom / Tile.MaxSide; y <= top / Tile.MaxSide; y++)
        {
            for (var x = left / Tile.MaxSide; x <= right / Tile.MaxSide; x++)
            {
                var (column, row) = (x * Tile.MaxSide, y * Tile.MaxSide);
                const uint Last = Tile.MaxSide - 1;
                var cells = Cells.Of(Math.Max(left, column), Math.Min(right, column + Last), Math.Max(bottom, row), Math.Min(top, row + Last));
                Items.Add((PlaceOf(x, y, side), new(first, mostW, cells)));
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int PlaceOf(uint tileX, uint tileY, int side) => 2 * ((int)tileY * tilesAcross + (int)tileX) + side;

    private static long Tiles(uint first, uint last) => last / Tile.MaxSide - first / Tile.MaxSide + 1L;
}
