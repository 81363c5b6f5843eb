namespace RayCaster.Engine;

/// <summary>A kernel that is compiled for each kind of shape.</summary>
internal interface IShapeVisitor
{
    /// <summary>Runs the kernel; returns whether it could.</summary>
    bool Visit<P>(P shape) where P : struct, IPrimitive;
}
