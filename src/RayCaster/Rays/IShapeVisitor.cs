namespace RayCaster;

/// <summary>Code that is compiled for each type of shape, without a list of the types: <see cref="Model.Accept"/> calls it.</summary>
public interface IShapeVisitor
{
    /// <summary>Runs the code for a shape; returns whether the code supports it.</summary>
    bool Visit<P>(P shape) where P : struct, IPrimitive;
}
