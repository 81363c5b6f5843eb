namespace RayCaster.Engine;

/// <summary>Triangles on the screen, sorted into the tiles of the picture in which they may cover a sample.</summary>
internal sealed class ScreenTriangles<N> where N : struct, IPacket<N>
{
    private const int LeastForAThread = 1 << 15;

    private readonly int tilesAcross;
    private readonly Bins<int> triangles; // two places for each tile: those whose corners are seen one way around, and the others
    private readonly Bins<TriangleCluster> groups;

    /// <param name="corners">Where the triangles' corners are seen.</param>
    /// <param name="owners">The mesh's triangle that each belongs to; null where they are the same.</param>
    /// <param name="boxes">The boxes of the triangles' clusters; null where they are sorted one by one.</param>
    /// <param name="twins">Makes what knows that triangles are the same; null where that is not known.</param>
    public ScreenTriangles(
        ScreenSpace screen, Corners corners, int[]? owners, TriangleBoxes? boxes, Func<Duplicates>? twins, int threads)
    {
        (Corners, Owners) = (corners, owners);
        tilesAcross = Tile.TilesOf(screen.Camera.Width);
        var sorters = new TriangleSorter[Math.Clamp(corners.Count / LeastForAThread, 1, threads)];
        for (var i = 0; i < sorters.Length; i++) sorters[i] = new(screen, corners, twins?.Invoke());
        var clusterSorters = boxes is null ? [] : Array.ConvertAll(sorters, each => new ClusterSorter<N>(screen, boxes, each));
        ThreadTeam.Shares(sorters.Length, boxes?.Count ?? corners.Count, (i, first, end) =>
        {
            if (boxes is null) sorters[i].Add(first, end);
            else clusterSorters[i].Add(first, end);
        });

        triangles = new(Array.ConvertAll(sorters, sorter => sorter.Triangles));
        groups = new(Array.ConvertAll(clusterSorters, sorter => sorter.Clusters));
        foreach (var sorter in sorters)
        {
            Large.AddRange(sorter.Large);
            Unfit.AddRange(sorter.Unfit);
            Extend(sorter.Extent);
        }
        foreach (var sorter in clusterSorters) Extend(sorter.Extent);
    }

    public Corners Corners { get; }

    /// <summary>The mesh's triangle that each belongs to; null where they are the same.</summary>
    public int[]? Owners { get; }

    /// <summary>Where samples may be covered.</summary>
    public (int Left, int Right, int Bottom, int Top) Extent { get; private set; } = (int.MaxValue, -1, int.MaxValue, -1);

    /// <summary>Triangles with corners that are not fit for floats; they are not sorted.</summary>
    public List<int> Unfit { get; } = [];

    /// <summary>Those that may show in any tile.</summary>
    public List<int> Large { get; } = [];

    /// <summary>Those of a tile that are seen with their corners one way (0) or the other way (1) around, but for those in groups.</summary>
    public ReadOnlySpan<int> Of(in Tile tile, int side) => triangles[2 * PlaceOf(tile) + side];

    /// <summary>Clusters of a tile most of which are seen one way or the other way around.</summary>
    public ReadOnlySpan<TriangleCluster> ClustersOf(in Tile tile, int side) => groups[2 * PlaceOf(tile) + side];

    /// <summary>Gives rented memory back; nothing may be asked for any more.</summary>
    public void Free()
    {
        triangles.Free();
        groups.Free();
    }

    private void Extend((int Left, int Right, int Bottom, int Top) other) => Extent = (
        Math.Min(Extent.Left, other.Left), Math.Max(Extent.Right, other.Right),
        Math.Min(Extent.Bottom, other.Bottom), Math.Max(Extent.Top, other.Top));

    private int PlaceOf(in Tile tile) => tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide;
}
