namespace RayCaster.Engine;

/// <summary>Triangles on the screen, sorted into the tiles of the picture in which they may cover a sample.</summary>
internal sealed class ScreenTriangles<N> where N : struct, IPacket<N>
{
    private const int MinForAThread = 1 << 15;

    private readonly int tilesAcross;
    private readonly Bins<TriangleCluster> triangles;

    /// <param name="owners">The mesh's triangle that each piece belongs to; null if these are the mesh's triangles.</param>
    /// <param name="boxes">The boxes of the clusters; null if triangles are sorted one by one.</param>
    /// <param name="duplicates">Makes a table of duplicates; null if it is not needed.</param>
    public ScreenTriangles(
        ScreenSpace screen, Corners corners, int[]? owners, TriangleBoxes? boxes, Func<Duplicates>? duplicates, int threads)
    {
        (Corners, Owners) = (corners, owners);
        tilesAcross = Tile.TilesOf(screen.Camera.Width);
        var binners = new TriangleBinner[Math.Clamp(corners.Count / MinForAThread, 1, threads)];
        for (var i = 0; i < binners.Length; i++) binners[i] = new(screen, corners, duplicates?.Invoke());
        var clusterBinners = boxes is null ? [] : Array.ConvertAll(binners, each => new ClusterBinner<N>(screen, boxes, each));
        ThreadTeam.Shares(binners.Length, boxes?.Count ?? corners.Count, (i, first, end) =>
        {
            if (boxes is null) binners[i].Add(first, end);
            else clusterBinners[i].Add(first, end);
        });

        triangles = new(Array.ConvertAll(binners, binner => binner.Lists.Items));
        foreach (var binner in binners)
        {
            Large.AddRange(binner.Large);
            Unfit.AddRange(binner.Unfit);
        }
    }

    public Corners Corners { get; }

    /// <summary>The mesh's triangle that each piece belongs to; null if these are the mesh's triangles.</summary>
    public int[]? Owners { get; }

    /// <summary>Triangles with a corner that is not fit for floats; they are not sorted.</summary>
    public List<int> Unfit { get; } = [];

    /// <summary>Triangles that may show in any tile.</summary>
    public List<TriangleRun> Large { get; } = [];

    /// <summary>What may show in a tile.</summary>
    public ReadOnlySpan<TriangleCluster> Of(in PixelRect tile) => triangles[tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide];

    /// <summary>Returns rented memory; the object cannot be used any more.</summary>
    public void Free() => triangles.Free();
}
