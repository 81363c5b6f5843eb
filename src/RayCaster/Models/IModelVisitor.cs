namespace RayCaster;

/// <summary>Does something for each kind of model that it could not do for all kinds alike: <see cref="Model.Accept"/> calls the method that
/// fits.</summary>
public interface IModelVisitor
{
    /// <summary>Visits a model whose shape states its crossing as a formula.</summary>
    /// <typeparam name="P">The kind of shape.</typeparam>
    void Visit<P>(Model<P> model) where P : struct, IPrimitive;

    /// <summary>Visits a mesh.</summary>
    void Visit(Mesh mesh);

    /// <summary>Visits a model in plain doubles and ifs, which knows only single rays.</summary>
    void VisitOther(Model model);
}
