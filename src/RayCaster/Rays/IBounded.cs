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

/// <summary>A shape with a bounding sphere, which bounds it more tightly than a box.</summary>
public interface IBoundingSphere : IBounded
{
    /// <summary>The bounding sphere's centre.</summary>
    Vector3 Center { get; }

    /// <summary>The bounding sphere's radius.</summary>
    double Radius { get; }

    Bounds IBounded.Bounds => new(Center - new Vector3(Radius, Radius, Radius), Center + new Vector3(Radius, Radius, Radius));
}
