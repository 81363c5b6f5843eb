using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A triangle, visible from both sides whatever the order of its corners (slide "Triangle").</summary>
/// <param name="A">The first corner.</param>
/// <param name="B">The second corner.</param>
/// <param name="C">The third corner, not on one line with the others.</param>
public readonly record struct Triangle(Vector3 A, Vector3 B, Vector3 C) : IPrimitive, IBounded, ISurface
{
    /// <inheritdoc/>
    public Bounds Bounds => Bounds.Empty.With(A).With(B).With(C);

    /// <summary>The crossing X = w A + u B + v C of the triangle's plane, where w, u and v, which add up to 1, are all ≥ 0.</summary>
    /// <remarks>
    /// <para>Seen along the ray the triangle is flat and the ray is the point (0, 0): w, u and v are to each other as the areas of
    /// the three triangles that this point makes with the sides, and t is the mean of the corners' depths with these weights. Only
    /// an edge-on triangle (d·n = 0) has no area: 0 / 0, NaN.</para>
    /// <para>Nearly edge-on, the areas are all noise, and may by chance agree for a ray that passes far from the triangle, within its
    /// plane. So the ray must also lie between the corners, across and upwards; one that is truly inside always does.</para>
    /// <para>No ray slips between two triangles that share a side. Both see its corners at the same place, so the area over it is the same
    /// to the bit but for its sign, and rounding can make the difference of two products 0 but never turn its sign. So the triangles
    /// cover the view like tiles, corners included (after Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013).</para>
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => Intersect(new AlongRay<N>(ray));

    /// <summary>The same, for a caller that asks about many triangles and one ray.</summary>
    // not inlined: in a caller grown too large operators, silently, become calls
    [MethodImpl(MethodImplOptions.AggressiveOptimization | MethodImplOptions.NoInlining)]
    public Crossings<N> Intersect<N>(in AlongRay<N> along) where N : struct, IReal<N> => Intersect(along, A, B, C);

    /// <summary>The same for corners over any kind of number: in a packet each lane has its own triangle.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Crossings<N> Intersect<N>(in AlongRay<N> along, Vector3<N> cornerA, Vector3<N> cornerB, Vector3<N> cornerC)
        where N : struct, IReal<N>
    {
        var (a, b, c) = (along.See(cornerA), along.See(cornerB), along.See(cornerC));
        var w = (b.X * c.Y - b.Y * c.X).As("w");
        var u = (c.X * a.Y - c.Y * a.X).As("u");
        var v = (a.X * b.Y - a.Y * b.X).As("v");
        var inside = ((u >= 0) & (v >= 0) & (w >= 0)) | ((u <= 0) & (v <= 0) & (w <= 0));
        var between = ((a.X <= 0) | (b.X <= 0) | (c.X <= 0)) & ((a.X >= 0) | (b.X >= 0) | (c.X >= 0))
            & ((a.Y <= 0) | (b.Y <= 0) | (c.Y <= 0)) & ((a.Y >= 0) | (b.Y >= 0) | (c.Y >= 0));
        var t = (w * a.Z + u * b.Z + v * c.Z) / ((w + u + v) * along.ZPerT);
        return new(N.If(inside & between, t));
    }

    /// <summary>
    /// Whether three points span no area: |e1 × e2| ≤ 1e-12 · (longest side)², so that it does not depend on the unit of length.
    /// </summary>
    public static bool IsOnOneLine(Vector3 a, Vector3 b, Vector3 c)
    {
        var longest = Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));
        return ((b - a) % (c - a)).Length <= 1e-12 * longest * longest;
    }

    /// <summary>(B − A) × (C − A), made 1 long.</summary>
    Vector3 ISurface.Normal(Vector3 X) => ((B - A) % (C - A)).Normalized;

    /// <summary>Barycentric: X = (1 − u − v) A + u B + v C.</summary>
    (double U, double V) ISurface.Parameters(Vector3 X)
    {
        var size = Math.Max((B - A).Length, (C - A).Length); // whose fourth power may be beyond the largest number
        var (e1, e2, p) = ((B - A) / size, (C - A) / size, (X - A) / size);
        var n = e1 % e2;
        return (p % e2 * n / (n * n), e1 % p * n / (n * n));
    }
}
