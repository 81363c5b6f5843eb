namespace RayCaster.Engine;

/// <summary>A view of a single shape. If the shape certainly covers a tile, a kernel for its kind of shape can do the whole tile.</summary>
internal interface ICoveringView
{
    /// <summary>Calls the visitor with the shape; returns what that returns.</summary>
    bool Accept(IShapeVisitor visitor);
}

/// <summary>A kernel that is compiled for each kind of shape.</summary>
internal interface IShapeVisitor
{
    /// <summary>Runs the kernel; returns whether it could.</summary>
    bool Visit<P>(P shape) where P : struct, IPrimitive;
}
