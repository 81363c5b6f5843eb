using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster;

/// <summary>
/// The slides' own algebra, for mistakes that are made in it and have no counterpart in the definition's formulas. Right as it stands here,
/// but for rounding.
/// </summary>
internal static class SlideFormulas
{
    /// <summary>No crossing.</summary>
    public static Crossed None => new(double.NaN);

    /// <summary>Crossings with every t taken for another.</summary>
    public static Crossed Select(this Crossed crossed, Func<double, double> t) => new(t(crossed.Near), t(crossed.Far));

    /// <summary>Slide "Sphere – Analytic Solution": the roots of a t² + b t + c = 0, from its discriminant.</summary>
    public static Crossed Roots(double a, double b, double discriminant) =>
        new((-b - Math.Sqrt(discriminant)) / (2 * a), (-b + Math.Sqrt(discriminant)) / (2 * a));

    /// <summary>The three slabs of a box and what they share.</summary>
    /// <param name="lab">Where the ray starts.</param>
    /// <param name="box">The box.</param>
    /// <param name="d">The ray's direction.</param>
    /// <param name="slab">(lo, hi, origin, direction) → the ways in and out of a slab.</param>
    /// <param name="lastIn">Of two ways in the one that counts.</param>
    /// <param name="firstOut">Of two ways out the one that counts.</param>
    public static Crossed Slabs(Lab lab, Aabb box, Vector3 d, Func<double, double, double, double, (double In, double Out)> slab,
        Func<double, double, double> lastIn, Func<double, double, double> firstOut)
    {
        var x = slab(box.Min.X, box.Max.X, lab.P.X, d.X);
        var y = slab(box.Min.Y, box.Max.Y, lab.P.Y, d.Y);
        var z = slab(box.Min.Z, box.Max.Z, lab.P.Z, d.Z);
        var tMin = lastIn(lastIn(x.In, y.In), z.In);
        var tMax = firstOut(firstOut(x.Out, y.Out), z.Out);
        return tMin <= tMax ? new(tMin, tMax) : None;
    }

    /// <summary>One slab: t0 and t1 sorted; a ray along it is in it for ever or never, on its face too.</summary>
    public static (double In, double Out) Slab(double lo, double hi, double origin, double direction) =>
        direction == 0 ? AlongSlab(lo, hi, origin) : Sorted((lo - origin) / direction, (hi - origin) / direction);

    /// <summary>A slab that the ray runs along.</summary>
    public static (double In, double Out) AlongSlab(double lo, double hi, double origin) => lo <= origin && origin <= hi
        ? (double.NegativeInfinity, double.PositiveInfinity)
        : (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The lesser first; no number if one is none.</summary>
    public static (double, double) Sorted(double t0, double t1) => (Math.Min(t0, t1), Math.Max(t0, t1));

    /// <summary>Slide "Triangle – Barycentric Coordinates": n = (B − A) × (C − A), u and v the shares of the area that X cuts off.</summary>
    /// <param name="lab">Whose cross product is used.</param>
    /// <param name="triangle">The triangle.</param>
    /// <param name="d">The ray's direction.</param>
    /// <param name="inside">(u, v) → whether X is in the triangle.</param>
    public static Crossed Triangle(Lab lab, Triangle triangle, Vector3 d, Func<double, double, bool> inside)
    {
        var (n, t, _, overB, overC) = Areas(lab, triangle, d);
        return inside(overB * n / (n * n), overC * n / (n * n)) ? new(t) : None;
    }

    /// <summary>n, the crossing of the plane, and the cross products over the sides a, b and c, as long as twice the areas.</summary>
    public static (Vector3 N, double T, Vector3 OverA, Vector3 OverB, Vector3 OverC) Areas(Lab lab, Triangle triangle, Vector3 d)
    {
        var (A, B, C) = (triangle.A, triangle.B, triangle.C);
        var cross = lab.Cross.Do;
        var n = cross(B - A, C - A);
        var t = (A - lab.P) * n / (d * n);
        var X = lab.P + t * d;
        return (n, t, cross(C - B, X - B), cross(A - C, X - C), cross(B - A, X - A));
    }
}
