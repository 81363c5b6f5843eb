namespace RayCaster;

/// <summary>
/// A shape with a box around it. A shape need not implement this: without bounds all rays are tested against it, which takes longer in a
/// scene of thousands.
/// </summary>
public interface IBounded
{
    /// <summary>A box around the shape. It may be larger than needed, never smaller.</summary>
    Bounds Bounds { get; }
}
