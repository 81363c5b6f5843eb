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

/// <summary>A shape within a ball, which bounds round shapes more tightly than a box.</summary>
public interface IRound
{
    /// <summary>The centre of the ball.</summary>
    Vector3 Center { get; }

    /// <summary>The radius of the ball: no point of the shape is farther from its centre.</summary>
    double Radius { get; }
}
