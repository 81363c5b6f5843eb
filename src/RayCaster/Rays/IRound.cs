namespace RayCaster;

/// <summary>A shape within a ball, which bounds it more tightly than a box.</summary>
public interface IRound : IBounded
{
    /// <summary>The ball's centre.</summary>
    Vector3 Center { get; }

    /// <summary>The ball's radius.</summary>
    double Radius { get; }

    Bounds IBounded.Bounds => new(Center - new Vector3(Radius, Radius, Radius), Center + new Vector3(Radius, Radius, Radius));
}
