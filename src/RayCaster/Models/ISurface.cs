namespace RayCaster;

/// <summary>
/// A shape that knows the normals and parameters of its surface. A shape need not implement this: maps then compute normals from neighbouring
/// hits, and u and v are 0 (docs/maps.md).
/// </summary>
public interface ISurface
{
    /// <summary>A vector of length 1 perpendicular to the surface, towards either side.</summary>
    /// <param name="X">A point of the surface, up to rounding.</param>
    Vector3 Normal(Vector3 X);

    /// <summary>Where on the surface a point lies. Each shape defines what its u and v measure.</summary>
    /// <inheritdoc cref="Normal"/>
    (double U, double V) Parameters(Vector3 X);
}
