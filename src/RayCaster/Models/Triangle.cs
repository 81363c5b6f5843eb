using System.Runtime.CompilerServices;

namespace RayCaster;

/// <summary>A triangle, visible from both sides whatever the order of its corners (slide "Triangle – Barycentric Coordinates").</summary>
/// <param name="A">The first corner.</param>
/// <param name="B">The second corner.</param>
/// <param name="C">The third corner, not on one line with the others.</param>
public readonly record struct Triangle(Vector3 A, Vector3 B, Vector3 C) : IPrimitive
{
    private readonly Vector3 normal = (B - A) % (C - A);

    /// <summary>The crossing X of the triangle's plane, where X = w A + u B + v C with u ≥ 0, v ≥ 0 and w = 1 − u − v ≥ 0.</summary>
    /// <remarks>
    /// <para>Seen along the ray the triangle is flat and the ray is the point (0, 0), so u, v and w are to each other as the areas of the
    /// three triangles that this point makes with the sides. Only their signs matter: all alike, 0 included, is inside.</para>
    /// <para>No ray slips between two triangles that share a side: both see the same two corners at the same place, the area over the side is the same
    /// to the bit but for its sign, and rounding can make a difference of two products 0 but never turn its sign. So the triangles
    /// cover the picture plane like tiles, corners included (after Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection", 2013).</para>
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Crossings<N> Cross<N>(in Ray<N> ray) where N : struct, IReal<N> => Cross(ray, new AlongRay<N>(ray));

    /// <summary>The same for a caller that asks about many triangles and one ray.</summary>
    /// <param name="ray">The ray.</param>
    /// <param name="along">The view along that ray.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Crossings<N> Cross<N>(in Ray<N> ray, in AlongRay<N> along) where N : struct, IReal<N>
    {
        var t = new Plane(A, normal).Cross(ray).Near;

        var (ax, ay) = along.See(A);
        var (bx, by) = along.See(B);
        var (cx, cy) = along.See(C);
        var w = bx * cy - by * cx;
        var u = cx * ay - cy * ax;
        var v = ax * by - ay * bx;
        var inside = ((u >= 0) & (v >= 0) & (w >= 0)) | ((u <= 0) & (v <= 0) & (w <= 0));
        return new(N.If(inside, t));
    }

    /// <summary>Whether three points span no area: |e1 × e2| ≤ 1e-12 · (longest side)², so that it does not depend on the unit of length.</summary>
    public static bool IsOnOneLine(Vector3 a, Vector3 b, Vector3 c)
    {
        var longest = Math.Max((b - a).Length, Math.Max((c - b).Length, (a - c).Length));
        return ((b - a) % (c - a)).Length <= 1e-12 * longest * longest;
    }
}
