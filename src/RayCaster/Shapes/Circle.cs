namespace RayCaster;

/// <summary>A flat disc, visible from both sides (slide "Circle").</summary>
/// <param name="Center">C.</param>
/// <param name="Normal">n, across the disc; any length but zero.</param>
/// <param name="Radius">R &gt; 0; the rim belongs to the disc.</param>
public readonly record struct Circle(Vector3 Center, Vector3 Normal, double Radius) : IPrimitive, IBoundingSphere
{
    /// <summary>The crossing X of the circle's plane, where |X − C| ≤ R. Compares squares: |X − C|² ≤ R².</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var t = new Plane(Center, Normal).Intersect(ray).Near;
        var CX = (ray.At(t) - Center).As("CX"); // infinite or NaN for a parallel ray, so that no comparison holds
        return new(N.If((CX * CX <= Radius * Radius).As("inside"), t));
    }
}
