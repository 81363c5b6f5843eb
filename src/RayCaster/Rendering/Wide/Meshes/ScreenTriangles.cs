using System.Runtime.Intrinsics;

namespace RayCaster;

/// <summary>Projected triangles, sorted into the tiles of the picture in which they may cover a sample.</summary>
internal sealed class ScreenTriangles
{
    private const int LeastForAThread = 1 << 15;

    private readonly int tilesAcross;
    private readonly Bins<int> triangles; // two places for each tile: those whose corners are seen one way around, and the others
    private readonly Bins<Spot> spots;

    /// <param name="screen">The camera.</param>
    /// <param name="points">x, y, w and whether it is unfit, of each vertex.</param>
    /// <param name="indices">Three vertices for each triangle.</param>
    /// <param name="owners">The mesh's triangle that each belongs to; null where they are the same.</param>
    /// <param name="threads">How many threads may work.</param>
    public ScreenTriangles(ScreenSpace screen, Vector128<float>[] points, int[] indices, int[]? owners, int threads)
    {
        (Points, Indices, Owners) = (points, indices, owners);
        tilesAcross = Frame.TilesOf(screen.Camera.Width);
        var count = indices.Length / 3;
        var sorters = new TriangleSorter[Math.Clamp(count / LeastForAThread, 1, threads)];
        for (var i = 0; i < sorters.Length; i++) sorters[i] = new(screen, this);
        int First(int sorter) => (int)((long)count * sorter / sorters.Length) & ~7;
        InParallel(sorters.Length, i => sorters[i].Add(First(i), i + 1 == sorters.Length ? count : First(i + 1)));

        var tiles = tilesAcross * Frame.TilesOf(screen.Camera.Height);
        triangles = new(2 * tiles, Array.ConvertAll(sorters, sorter => sorter.Triangles));
        spots = new(tiles, Array.ConvertAll(sorters, sorter => sorter.Spots));
        Large = [.. sorters.SelectMany(sorter => sorter.Large)];
        Unfit = [.. sorters.SelectMany(sorter => sorter.Unfit)];
        Extent = (sorters.Min(s => s.Extent.Left), sorters.Max(s => s.Extent.Right), sorters.Min(s => s.Extent.Bottom), sorters.Max(s => s.Extent.Top));
    }

    public Vector128<float>[] Points { get; }

    public int[] Indices { get; }

    public int[]? Owners { get; }

    /// <summary>Where samples may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent { get; }

    /// <summary>Triangles with corners that are not fit for floats; they are not sorted.</summary>
    public int[] Unfit { get; }

    /// <summary>Those that may show in any tile.</summary>
    public int[] Large { get; }

    /// <summary>Those of a tile that are seen with their corners one way (0) or the other way (1) around.</summary>
    public ReadOnlySpan<int> Of(in Tile tile, int side) => triangles[2 * PlaceOf(tile) + side];

    /// <summary>Those of a tile that cover at most one sample.</summary>
    public ReadOnlySpan<Spot> SpotsOf(in Tile tile) => spots[PlaceOf(tile)];

    /// <summary>Does work for each number below a count, on a thread for each.</summary>
    public static void InParallel(int count, Action<int> work)
    {
        if (count == 1) work(0);
        else Parallel.For(0, count, work);
    }

    private int PlaceOf(in Tile tile) => tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide;
}
