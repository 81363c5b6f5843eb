namespace RayCaster.Engine;

/// <summary>
/// A mesh as a camera sees it. All rays of a picture start in one point, so a filter in floats can project the triangles and find for each pixel the
/// one that is certainly in front; where that is not certain it proposes several. The triangle's formula then decides which is hit, and where.
/// </summary>
internal sealed class MeshView<N> : ModelView<N>, ITileView where N : struct, IPacket<N>
{
    private readonly ScreenSpace screen;
    private readonly Vector3[] vertices;
    private readonly int[] indices;
    private readonly ScreenTriangles<N>[] sets = []; // the triangles, and the pieces of those that had to be clipped
    private readonly TriangleTree? hard;             // over the triangles that the filter cannot judge
    private readonly TileFilters<N>? filters;        // of one thread, for all meshes
    private TileFilter<N>? filter;                   // holds this mesh's pixels until another mesh takes it
    private Tile entered;
    private bool shows;                              // whether a triangle may show in that tile

    /// <param name="isKept">Whether what depends only on the mesh stays in memory for the next picture.</param>
    public MeshView(Mesh mesh, ScreenSpace screen, bool isKept = false, int threads = 1)
    {
        (vertices, indices, this.screen) = (mesh.Vertices, mesh.Indices, screen);
        if (!screen.IsFine)
        {
            hard = new(vertices, indices);
            Extent = Tile.Everywhere;
            return;
        }

        var whole = new ScreenTriangles<N>(
            screen, new MeshCorners<N>(screen, vertices, indices), null,
            TriangleBoxes.Of(mesh, screen.Camera, isKept, threads), () => new Duplicates(vertices, indices), threads);

        var clipper = new ScreenClipper(screen, vertices);
        foreach (var i in whole.Unfit) clipper.Add(i, indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]);
        var clipped = new ScreenTriangles<N>(screen, new PieceCorners(clipper.Points), clipper.Owners, null, null, threads);
        sets = [whole, clipped];

        if (clipper.Hard.Count > 0) hard = new(vertices, [.. clipper.Hard]);
        Extent = hard is null ? ExtentOf(whole.Extent, clipped.Extent) : Tile.Everywhere;
    }

    private MeshView(MeshView<N> shared, TileFilters<N> filters)
    {
        (screen, vertices, indices, sets, hard, Extent) = (shared.screen, shared.vertices, shared.indices, shared.sets, shared.hard, shared.Extent);
        this.filters = filters;
    }

    public override Tile Extent { get; }

    public override ModelView<N> ForThread(ThreadTools? tools = null) => new MeshView<N>(this, (tools ?? new()).Of<TileFilters<N>>());

    public override HitRange Enter(in Tile tile, HitRange known)
    {
        if (sets.Length == 0) return known;
        entered = tile;
        var range = Enter();
        return hard is null ? range : range with { Least = 0 };
    }

    public override void Meet(RayStream rays, int index)
    {
        if (shows) OwnFilter().Meet(rays, index);
        if (hard is null) return;
        for (var i = 0; i < rays.Length; i += N.Count) rays.Keep(i, hard.Nearest<N>(rays, i), Lanes.Broadcast<N>(index));
    }

    public override void Free()
    {
        foreach (var set in sets) set.Free();
    }

    public bool Paint(Scene scene, int index, byte[] rgb, int first, int step)
    {
        if (hard is not null) return false;
        var painter = filters!.PainterOf(screen, scene, index);
        if (painter.IsSupported) OwnFilter().Paint(painter, rgb, first, step);
        return painter.IsSupported;
    }

    private HitRange Enter()
    {
        filter = filters!.Take(screen, entered);
        filter.Show(this, vertices, indices);
        var range = filter.Enter(entered, sets);
        shows = filter.Owner == this;
        return range;
    }

    /// <summary>The filter that holds this mesh's pixels in the entered tile. If another mesh has taken it, the tile is entered anew.</summary>
    private TileFilter<N> OwnFilter()
    {
        if (filter!.Owner != this || filter.Tile != entered) Enter();
        return filter;
    }

    private static Tile ExtentOf((int Left, int Right, int Bottom, int Top) a, (int Left, int Right, int Bottom, int Top) b)
    {
        var (left, right) = (Math.Min(a.Left, b.Left), Math.Max(a.Right, b.Right));
        var (bottom, top) = (Math.Min(a.Bottom, b.Bottom), Math.Max(a.Top, b.Top));
        return right < left ? default : new(left, bottom, right - left + 1, top - bottom + 1);
    }
}
