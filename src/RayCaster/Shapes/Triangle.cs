namespace RayCaster;

/// <summary>A triangle, visible from both sides, in any order of its corners (slide "Triangle").</summary>
/// <param name="C">The third corner, not on one line with the others.</param>
public readonly record struct Triangle(Vector3 A, Vector3 B, Vector3 C) : IPrimitive, IBounded
{
    /// <inheritdoc/>
    public Bounds Bounds => Bounds.Empty.With(A).With(B).With(C);

    /// <summary>The crossing X = w A + u B + v C of the triangle's plane, where w, u and v, which add up to 1, are all ≥ 0.</summary>
    /// <remarks>
    /// <para>In the view along the ray the ray is the point (0, 0). This point and the triangle's sides make three triangles; w, u and v are
    /// twice their signed areas, and t is the mean of the corners' depths with these weights. A triangle seen edge-on (d·n = 0) has no area: 0 / 0,
    /// NaN.</para>
    /// <para>If a triangle is seen nearly edge-on, its areas are nothing but rounding errors, and may have equal signs for a ray that passes far
    /// from it, within its plane. So (0, 0) must also lie between the corners in X and in Y, which is always true inside.</para>
    /// <para>No ray passes between two triangles that share a side. Both see its two corners at the same places, so they compute the same area
    /// over it, with opposite signs; and rounding can make the difference of two products 0, but never change its sign. So the triangles cover
    /// the view without gaps, also at corners (after Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013).</para>
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => Intersect(new RaySpace<N>(ray));

    /// <summary>The same, for a caller that intersects many triangles with one ray.</summary>
    // Not inlined: in a method that grows too large, the runtime silently turns inlined operators into calls.
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    public Crossings<N> Intersect<N>(in RaySpace<N> along) where N : struct, IReal<N> => Intersect(along, A, B, C);

    /// <summary>The same for corners over any kind of number: for several triangles at once.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Crossings<N> Intersect<N>(in RaySpace<N> along, Vector3<N> cornerA, Vector3<N> cornerB, Vector3<N> cornerC)
        where N : struct, IReal<N>
    {
        var (a, b, c) = (along.Transform(cornerA), along.Transform(cornerB), along.Transform(cornerC));
        var w = (b.X * c.Y - b.Y * c.X).As("w");
        var u = (c.X * a.Y - c.Y * a.X).As("u");
        var v = (a.X * b.Y - a.Y * b.X).As("v");
        var inside = ((u >= 0) & (v >= 0) & (w >= 0)) | ((u <= 0) & (v <= 0) & (w <= 0));
        var between = ((a.X <= 0) | (b.X <= 0) | (c.X <= 0)) & ((a.X >= 0) | (b.X >= 0) | (c.X >= 0))
            & ((a.Y <= 0) | (b.Y <= 0) | (c.Y <= 0)) & ((a.Y >= 0) | (b.Y >= 0) | (c.Y >= 0));
        var t = (w * a.Z + u * b.Z + v * c.Z) / ((w + u + v) * along.Dz);
        return new(N.If(inside & between, t));
    }
}
