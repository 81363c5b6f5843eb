namespace RayCaster.Engine;

/// <summary>The models of a picture as the camera sees them, each by itself or as one of a batch.</summary>
internal sealed class Frame<N> : Frame, IModelVisitor where N : struct, IPacket<N>
{
    /// <summary>With fewer models, testing each of them is cheaper than lists for parts of the picture.</summary>
    private const int FewModels = 64;

    private readonly List<ModelView> views = [];
    private readonly CancellationToken cancellation;

    /// <inheritdoc cref="Frame.Of"/>
    public Frame(Scene scene, int threads, bool manyFrames, CancellationToken cancellation, bool isPlain)
        : base(scene, threads, manyFrames, isPlain)
    {
        this.cancellation = cancellation;
        var (camera, models) = (scene.Camera, scene.Models);
        if (models.Count > FewModels && !camera.IsSkewed)
            PrimitiveBatch = new(camera, ShapeLists.Of(models, manyFrames, threads), models.Count, threads);
        ModelIndices = PrimitiveBatch is null ? new int[models.Count] : [.. PrimitiveBatch.Others];
        for (var i = 0; PrimitiveBatch is null && i < models.Count; i++) ModelIndices[i] = i;
        foreach (var i in ModelIndices)
        {
            cancellation.ThrowIfCancellationRequested();
            models[i].Accept(this);
        }
        Extents = Array.ConvertAll(Views, view => view.Extent);
    }

    /// <summary>Views of the models that are not in the batch.</summary>
    public ModelView[] Views => [.. views];

    public int[] ModelIndices { get; }

    /// <summary>Where in the picture each of them can show at all.</summary>
    public Tile[] Extents { get; }

    /// <summary>The other models; null if there are few.</summary>
    public PrimitiveBatch<N>? PrimitiveBatch { get; }

    public override IStripCaster NewCaster() =>
        IsPlain && !UsesShapeKernels && PrimitiveBatch is null ? new PlainCaster<N>(this) : NewTileCaster();

    public override IHitConsumer HitsInto(HitMap map) => new HitMapConsumer<N>(map, Scene.Camera);

    public override void Dispose()
    {
        foreach (var view in views) view.Free();
        PrimitiveBatch?.Free();
    }

    void IModelVisitor.Visit<P>(Model<P> model) => views.Add(new PrimitiveView<P, N>(model.Primitive, Scene.Camera));

    void IModelVisitor.Visit(Mesh mesh) => views.Add(new MeshView<N>(mesh, new(Scene.Camera), cancellation, ManyFrames, Threads));

    void IModelVisitor.VisitOther(Model model) => views.Add(new SingleRayView(model, Scene.Camera));

    /// <remarks>A method of its own, so that the tile caster's code is not loaded if it is not needed.</remarks>
    private IStripCaster NewTileCaster() => new TileCaster<N>(this);
}
