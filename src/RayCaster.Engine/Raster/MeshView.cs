namespace RayCaster.Engine;

/// <summary>
/// A mesh as a camera sees it. All rays of a picture start in one point, so a filter in floats can project the triangles and find for each pixel the
/// one that is certainly in front; where that is not certain it proposes several. The triangle's formula then decides which is hit, and where.
/// </summary>
internal sealed class MeshView<N> : ModelView where N : struct, IPacket<N>
{
    private readonly ScreenSpace screen;
    private readonly Vector3[] vertices;
    private readonly int[] indices;
    private readonly ScreenTriangles<N>[] sets = []; // the triangles, and the pieces of those that had to be clipped
    private readonly TriangleTree? formulaOnly;      // over the triangles that the filter cannot handle
    private readonly TileFilters<N>? filters;        // of one thread, for all meshes
    private TileFilter<N>? filter;                   // holds this mesh's pixels of the entered tile; null if none shows there

    public MeshView(Mesh mesh, ScreenSpace screen, CancellationToken cancellation, int threads = 1)
    {
        (vertices, indices, this.screen) = (mesh.Vertices, mesh.Indices, screen);
        if (!screen.IsFine)
        {
            formulaOnly = new(vertices, indices, cancellation);
            ShowsIn = PixelRect.Everywhere;
            return;
        }

        var boxes = TriangleBoxes.Of(mesh, cancellation, threads);
        var whole = new ScreenTriangles<N>(
            screen, new MeshCorners<N>(screen, vertices, indices), null, boxes, () => new Duplicates(vertices, indices), threads);
        cancellation.ThrowIfCancellationRequested();

        var clipper = new ScreenClipper(screen, vertices);
        foreach (var i in whole.Unfit) clipper.Add(i, indices[3 * i], indices[3 * i + 1], indices[3 * i + 2]);
        var clipped = new ScreenTriangles<N>(screen, new ClippedCorners(clipper.Points), clipper.Owners, null, null, threads);
        sets = [whole, clipped];

        if (clipper.FormulaOnly.Count > 0) formulaOnly = new(vertices, [.. clipper.FormulaOnly], cancellation);
        ShowsIn = formulaOnly is null ? new ScreenBounds(screen.Camera).TileOf(boxes.Bounds) : PixelRect.Everywhere;
    }

    private MeshView(MeshView<N> shared, TileFilters<N> filters)
    {
        (screen, vertices, indices, sets) = (shared.screen, shared.vertices, shared.indices, shared.sets);
        (formulaOnly, ShowsIn) = (shared.formulaOnly, shared.ShowsIn);
        this.filters = filters;
    }

    public override PixelRect ShowsIn { get; }

    public override ModelView ForThread(ref object? shared) => new MeshView<N>(this, (TileFilters<N>)(shared ??= new TileFilters<N>(screen)));

    public override bool HoldsTile => true;

    public override HitRange Begin(in PixelRect tile, HitRange known)
    {
        if (sets.Length == 0) return known;
        filter = filters!.Next;
        var range = filter.Begin(tile, vertices, indices, sets);
        if (range == HitRange.None) filter = null;
        else filters.Keep();
        return formulaOnly is null ? range : range with { NearestT = 0 };
    }

    public override void Intersect(RayStream rays, int index)
    {
        filter?.Intersect(rays, index);
        if (formulaOnly is null) return;
        for (var i = 0; i < rays.Length; i += N.Count) rays.MergeNearest(i, formulaOnly.Nearest<N>(rays, i), Lanes.Broadcast<N>(index));
    }

    public override void Free()
    {
        foreach (var set in sets) set.Free();
    }

    public override bool Paint(Scene scene, int index, byte[] rgb, int first, int step)
    {
        if (formulaOnly is not null) return false;
        var painter = filters!.PainterOf(scene, index);
        if (painter.IsSupported) filter!.Paint(painter, rgb, first, step);
        return painter.IsSupported;
    }
}
