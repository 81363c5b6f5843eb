namespace RayCaster;

/// <summary>An infinite plane, visible from both sides (slide "Plane").</summary>
/// <param name="Point">Q, any point of the plane.</param>
/// <param name="Normal">n, perpendicular to the plane; any length but zero, because it cancels in t.</param>
public readonly record struct Plane(Vector3 Point, Vector3 Normal) : IPrimitive
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
}
