namespace RayCaster;

/// <summary>
/// A shape that knows its surface: which way it faces, and where on it a point lies. A shape need not; maps then take its normal from
/// neighbouring hits and leave u and v at 0 (docs/maps.md).
/// </summary>
public interface ISurface
{
    /// <summary>A vector across the surface, of length 1, towards either side.</summary>
    /// <param name="X">A point of the surface, but for rounding.</param>
    Vector3 Normal(Vector3 X);

    /// <summary>Where on the surface a point lies; what u and v measure is the shape's own choice, written where it is implemented.</summary>
    /// <inheritdoc cref="Normal"/>
    (double U, double V) Parameters(Vector3 X);
}
