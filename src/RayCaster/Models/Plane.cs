using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>An infinite plane, visible from both sides (slide "Plane").</summary>
/// <param name="Point">Q, any point of the plane.</param>
/// <param name="Normal">n, perpendicular to the plane; any length but zero, because it cancels in t.</param>
public readonly record struct Plane(Vector3 Point, Vector3 Normal) : IPrimitive, ISurface
{
    /// <summary>
    /// t = (Q − P)·n / d·n. A parallel ray divides by 0: t is infinite, or NaN for a ray in the plane, and never counts.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var t = ((Point - ray.Origin) * Normal / (ray.Direction * Normal)).As("t");
        return new(t);
    }

    /// <summary>n, normalised.</summary>
    Vector3 ISurface.Normal(Vector3 X) => Normal.Normalized;

    /// <summary>
    /// Distances from Q along two axes of the plane. u runs along z × n, which is horizontal, or along y × n where n is nearest to z; v runs
    /// along n × u. On a floor u and v run along x and y; on a wall v runs upwards.
    /// </summary>
    (double U, double V) ISurface.Parameters(Vector3 X)
    {
        var n = Normal.Normalized;
        var isLevel = Math.Abs(n.Z) >= Math.Max(Math.Abs(n.X), Math.Abs(n.Y));
        var u = ((isLevel ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1)) % n).Normalized;
        return ((X - Point) * u, (X - Point) * (n % u));
    }
}
