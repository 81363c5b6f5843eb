namespace RayCaster;

/// <summary>Treats each kind of model in its own way: <see cref="Model.Accept"/> calls the method for the model's kind.</summary>
public interface IModelVisitor
{
    /// <summary>Visits a model with a primitive, whose formula runs over any kind of number.</summary>
    void Visit<P>(Model<P> model) where P : struct, IPrimitive;

    /// <summary>Visits a mesh.</summary>
    void Visit(Mesh mesh);

    /// <summary>Visits a model that is written in plain doubles and ifs.</summary>
    void VisitOther(Model model);
}
