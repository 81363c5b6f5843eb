namespace RayCaster;

/// <summary>Code that is compiled for each kind of shape: what draws a shape fast need not list them (<see cref="Model.Accept"/>).</summary>
public interface IShapeVisitor
{
    /// <summary>Does it for a shape; returns whether it could.</summary>
    bool Visit<P>(P shape) where P : struct, IPrimitive;
}
