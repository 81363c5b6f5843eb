namespace RayCaster.Engine;

/// <summary>A line through a point, and where it enters bounds.</summary>
/// <param name="direction">The line's direction.</param>
public readonly struct Line(Vector3 origin, Vector3 direction)
{
    private readonly Vector3 inverse = new(1 / direction.X, 1 / direction.Y, 1 / direction.Z);

    /// <summary>Whether the line misses bounds.</summary>
    public bool Misses(Bounds bounds) => double.IsPositiveInfinity(Enters(bounds));

    /// <summary>The t at which the line enters bounds, also behind its origin; +∞ if it misses them.</summary>
    /// <remarks>In a face's plane 0 · ∞ is NaN; the result is then −∞, which rejects nothing.</remarks>
    public double Enters(Bounds bounds)
    {
        var (min, max) = bounds.PaddedFrom(origin);
        var (x0, x1) = (min.X * inverse.X, max.X * inverse.X);
        var (y0, y1) = (min.Y * inverse.Y, max.Y * inverse.Y);
        var (z0, z1) = (min.Z * inverse.Z, max.Z * inverse.Z);
        var enters = Math.Max(Math.Min(x0, x1), Math.Max(Math.Min(y0, y1), Math.Min(z0, z1)));
        var leaves = Math.Min(Math.Max(x0, x1), Math.Min(Math.Max(y0, y1), Math.Max(z0, z1)));
        return enters > leaves ? double.PositiveInfinity : double.IsNaN(enters) ? double.NegativeInfinity : enters;
    }
}
