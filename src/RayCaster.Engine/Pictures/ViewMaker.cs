namespace RayCaster.Engine;

/// <summary>Makes the view of a model.</summary>
internal sealed class ViewMaker<N> : IModelVisitor where N : struct, IPacket<N>
{
    private readonly Camera camera;
    private readonly bool isKept;
    private readonly int threads;
    private ModelView view = null!; // set by Accept, which calls one of the three methods

    private ViewMaker(Camera camera, bool isKept, int threads) => (this.camera, this.isKept, this.threads) = (camera, isKept, threads);

    /// <param name="isKept">Whether what depends only on the model stays in memory for the next picture.</param>
    public static ModelView Of(Model model, Camera camera, bool isKept, int threads)
    {
        var maker = new ViewMaker<N>(camera, isKept, threads);
        model.Accept(maker);
        return maker.view;
    }

    void IModelVisitor.Visit<P>(Model<P> model) => view = new PrimitiveView<P, N>(model.Primitive, camera);

    void IModelVisitor.Visit(Mesh mesh) => view = new MeshView<N>(mesh, new(camera), isKept, threads);

    void IModelVisitor.VisitOther(Model model) => view = new SingleRayView(model);
}
