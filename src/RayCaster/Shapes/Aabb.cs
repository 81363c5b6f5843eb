namespace RayCaster;

/// <summary>A box with its sides along the axes (slide "AABB (Axis Aligned Bounding Box)"); it may be flat.</summary>
/// <param name="Min">B0, the corner with the least coordinates.</param>
/// <param name="Max">B1, the corner with the greatest coordinates.</param>
public readonly record struct Aabb(Vector3 Min, Vector3 Max) : IPrimitive, IBounded
{
    /// <inheritdoc/>
    public Bounds Bounds => new(Min, Max);

    /// <summary>The box is the intersection of three slabs. t_min is the last entry into a slab, t_max the first exit; the ray hits the box if
    /// t_min ≤ t_max.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var x = Slab<N>(Min.X, Max.X, ray.Origin.X, ray.Direction.X);
        var y = Slab<N>(Min.Y, Max.Y, ray.Origin.Y, ray.Direction.Y);
        var z = Slab<N>(Min.Z, Max.Z, ray.Origin.Z, ray.Direction.Z);
        var t_min = N.Max(x.Near, N.Max(y.Near, z.Near)).As("t_min");
        var t_max = N.Min(x.Far, N.Min(y.Far, z.Far)).As("t_max");
        var hit = t_min <= t_max;
        return new(N.If(hit, t_min), N.If(hit, t_max));
    }

    /// <summary>Where the ray enters and leaves the slab B0 ≤ coordinate ≤ B1, along one axis.</summary>
    /// <remarks>
    /// A ray parallel to the slab (d = 0) divides by 0. Inside this gives −∞ and +∞; outside twice the same infinity, so that the intersection
    /// is empty. Exactly on a face it gives 0 / 0, NaN: the face belongs to the slab, so the ray is inside from −∞ to +∞.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Crossings<N> Slab<N>(N B0, N B1, N P, N d) where N : struct, IReal<N>
    {
        var t0 = ((B0 - P) / d).As("t0");
        var t1 = ((B1 - P) / d).As("t1");
        return new(N.IfNaN(N.Min(t0, t1), double.NegativeInfinity), N.IfNaN(N.Max(t0, t1), double.PositiveInfinity));
    }
}
