using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A box with its sides along the axes (slide "Axis-aligned bounding box"); it may be flat.</summary>
/// <param name="Min">B0, the corner with the least coordinates.</param>
/// <param name="Max">B1, the corner with the greatest coordinates.</param>
public readonly record struct Aabb(Vector3 Min, Vector3 Max) : IPrimitive, IBounded
{
    /// <inheritdoc/>
    public Bounds Bounds => new(Min, Max);

    /// <summary>The box is what three slabs share: t_min is the last of the ways in, t_max the first of the ways out, if t_min ≤ t_max.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Cross<N>(in Ray<N> ray) where N : struct, IReal<N>
    {
        var x = Slab<N>(Min.X, Max.X, ray.Origin.X, ray.Direction.X);
        var y = Slab<N>(Min.Y, Max.Y, ray.Origin.Y, ray.Direction.Y);
        var z = Slab<N>(Min.Z, Max.Z, ray.Origin.Z, ray.Direction.Z);
        var tMin = N.Max(N.Max(x.Near, y.Near), z.Near).As("t_min");
        var tMax = N.Min(N.Min(x.Far, y.Far), z.Far).As("t_max");
        var hit = tMin <= tMax;
        return new(N.If(hit, tMin), N.If(hit, tMax));
    }

    /// <summary>Where the ray enters and leaves the space lo ≤ coordinate ≤ hi.</summary>
    /// <remarks>
    /// A ray along the slab (d = 0) divides by 0: inside that gives −∞ and +∞, outside twice the same infinity, which leaves nothing
    /// to share. Exactly on a face it gives 0 / 0, NaN: the face belongs to the slab, so the ray is in it for ever.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Crossings<N> Slab<N>(N lo, N hi, N origin, N direction) where N : struct, IReal<N>
    {
        var t0 = ((lo - origin) / direction).As("t0");
        var t1 = ((hi - origin) / direction).As("t1");
        return new(N.Or(N.Min(t0, t1), double.NegativeInfinity), N.Or(N.Max(t0, t1), double.PositiveInfinity));
    }
}
