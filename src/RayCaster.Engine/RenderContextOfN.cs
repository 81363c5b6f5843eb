namespace RayCaster.Engine;

/// <summary>The models of a picture as the camera sees them, each by itself or as one of a batch.</summary>
internal sealed class RenderContext<N> : RenderContext where N : struct, IPacket<N>
{
    public RenderContext(Scene scene, Plan plan, CancellationToken cancellation) : base(scene, plan)
    {
        var (camera, models) = (scene.Camera, scene.Models);
        if (plan.UsesBatch)
            PrimitiveBatch = new(camera, ShapeLists.Of(models, plan.KeepsLists, plan.Threads), models.Count, plan.Threads);
        ModelIndices = PrimitiveBatch is null ? new int[models.Count] : [.. PrimitiveBatch.Others];
        for (var i = 0; PrimitiveBatch is null && i < models.Count; i++) ModelIndices[i] = i;
        Views = Array.ConvertAll(ModelIndices, i => ViewOf(models[i], cancellation));
        ShowIn = Array.ConvertAll(Views, view => view.ShowsIn);
    }

    public ModelView[] Views { get; }

    public int[] ModelIndices { get; }

    public PixelRect[] ShowIn { get; }

    /// <summary>The other models; null if there are few.</summary>
    public PrimitiveBatch<N>? PrimitiveBatch { get; }

    public override StripCaster NewCaster() => new TileCaster<N>(this).Cast;

    public override IHitConsumer HitsInto(HitMap map) => new HitMapConsumer<N>(map, Scene.Camera);

    public override void Dispose()
    {
        foreach (var view in Views) view.Free();
        PrimitiveBatch?.Free();
    }

    private ModelView ViewOf(Model model, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        if (model is Mesh mesh) return new MeshView<N>(SpatialOrder.Of(mesh), new(Scene.Camera), cancellation, Plan.Threads);
        var formula = new FormulaView(model.Bounds, Scene.Camera);
        return model.Accept(formula) ? formula.View! : new SingleRayView(model, Scene.Camera);
    }

    /// <summary>Makes the view of a shape with a formula.</summary>
    private sealed class FormulaView(Bounds? bounds, Camera camera) : IShapeVisitor
    {
        public ModelView? View { get; private set; }

        public bool Visit<P>(P shape) where P : struct, IPrimitive
        {
            View = new PrimitiveView<P, N>(shape, bounds, camera);
            return true;
        }
    }
}
