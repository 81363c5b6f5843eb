using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>An endless plane, visible from both sides (slide "Plane").</summary>
/// <param name="Point">Q, any point of the plane.</param>
/// <param name="Normal">n, across the plane; any length but zero, for it cancels in t.</param>
public readonly record struct Plane(Vector3 Point, Vector3 Normal) : IPrimitive, ISurface
{
    /// <summary>
    /// t = (Q − P)·n / d·n. A parallel ray divides by 0: t is infinite, or NaN for a ray in the plane, and counts in no case.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var t = ((Point - ray.Origin) * Normal / (ray.Direction * Normal)).As("t");
        return new(t);
    }

    /// <summary>n, made 1 long.</summary>
    Vector3 ISurface.Normal(Vector3 X) => Normal.Normalized;

    /// <summary>
    /// Lengths from Q in the plane. v runs along n × u; u along z × n, which is level, or along y × n where n follows z most: on a floor
    /// u and v are x and y, on a wall v is up.
    /// </summary>
    (double U, double V) ISurface.Parameters(Vector3 X)
    {
        var n = Normal.Normalized;
        var isLevel = Math.Abs(n.Z) >= Math.Max(Math.Abs(n.X), Math.Abs(n.Y));
        var u = ((isLevel ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1)) % n).Normalized;
        return ((X - Point) * u, (X - Point) * (n % u));
    }
}
