namespace RayCaster.Engine;

/// <summary>Triangles on the screen, sorted into the tiles of the picture in which they may cover a sample.</summary>
internal sealed class ScreenTriangles<N> where N : struct, IPacket<N>
{
    private const int MinForAThread = 1 << 15;

    private readonly int tilesAcross;
    private readonly Bins<TriangleCluster> triangles;
    private readonly PooledList<TriangleCluster>[] large; // in many tiles
    private readonly int shift;

    /// <param name="owners">The mesh's triangle that each piece belongs to; null if these are the mesh's triangles.</param>
    /// <param name="boxes">The boxes of the clusters; null if triangles are sorted one by one.</param>
    /// <param name="duplicates">Makes a table of duplicates; null if it is not needed.</param>
    public ScreenTriangles(
        ScreenSpace screen, CornerSource corners, int[]? owners, TriangleBoxes? boxes, Func<Duplicates>? duplicates, int threads)
    {
        (Corners, Owners) = (corners, owners);
        (tilesAcross, shift) = (Tile.TilesOf(screen.Camera.Width), TriangleBinner.ShiftOf(screen.Camera));
        var binners = new TriangleBinner[Math.Clamp(corners.Count / MinForAThread, 1, threads)];
        for (var i = 0; i < binners.Length; i++) binners[i] = new(screen, corners, duplicates?.Invoke());
        var clusterBinners = boxes is null ? [] : Array.ConvertAll(binners, each => new ClusterBinner<N>(screen, boxes, each));
        ThreadTeam.Shares(binners.Length, boxes?.Count ?? corners.Count, (i, first, end) =>
        {
            if (boxes is null) binners[i].Add(first, end);
            else clusterBinners[i].Add(first, end);
        });

        triangles = new(Array.ConvertAll(binners, binner => binner.Lists.Items));
        large = Array.ConvertAll(binners, binner => binner.Large);
        foreach (var binner in binners) Unfit.AddRange(binner.Unfit);
    }

    public CornerSource Corners { get; }

    /// <summary>The mesh's triangle that each piece belongs to; null if these are the mesh's triangles.</summary>
    public int[]? Owners { get; }

    /// <summary>Triangles with a corner that is not fit for floats; they are not sorted.</summary>
    public List<int> Unfit { get; } = [];

    public ReadOnlySpan<TriangleCluster> Of(in PixelRect tile) => triangles[tile.Row / Tile.MaxSide * tilesAcross + tile.Column / Tile.MaxSide];

    /// <summary>Finds the triangles that may show in a tile and many others.</summary>
    [MethodImpl(MethodImplOptions.NoInlining | MethodImplOptions.AggressiveOptimization)]
    public void FindLarge(in PixelRect tile, PooledList<TriangleCluster> found)
    {
        found.Clear();
        var (column, row) = (tile.Column >> shift, tile.Row >> shift);
        foreach (var list in large)
            foreach (ref readonly var item in list.Items)
                if (item.Cells.Left <= column && item.Cells.Right >= column && item.Cells.Bottom <= row && item.Cells.Top >= row)
                    found.Add(item with { Cells = Cells.All });
    }

    /// <summary>Returns rented memory; the object cannot be used any more.</summary>
    public void Free()
    {
        triangles.Free();
        foreach (var list in large) list.Free();
    }
}
