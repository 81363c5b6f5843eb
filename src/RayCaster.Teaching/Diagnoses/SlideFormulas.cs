using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>
/// The slides' own algebra, for mistakes that are made in it and have no counterpart in the definition's formulas. Right as it stands here,
/// but for rounding.
/// </summary>
internal static class SlideFormulas
{
    /// <summary>A coordinate: 0 is x, 1 is y, 2 is z.</summary>
    public static double At(this Vector3 a, int axis) => axis switch { 0 => a.X, 1 => a.Y, _ => a.Z };

    /// <summary>No crossing.</summary>
    public static Crossed None => new(double.NaN);

    /// <summary>Both crossings, the far one first.</summary>
    public static Crossed Turned(Crossed crossed) => new(crossed.Far, crossed.Near);

    /// <summary>tca ∓ thc.</summary>
    public static Crossed Roots(double tca, double thc) => new(tca - thc, tca + thc);

    /// <summary>Slide "Sphere – Geometric Solution", for d·d = 1 with any d.</summary>
    /// <param name="lab">Where the ray starts.</param>
    /// <param name="s">The sphere.</param>
    /// <param name="d">The ray's direction.</param>
    /// <param name="roots">(R, tca, D²) → the crossings; tca ∓ √(R² − D²) if left out.</param>
    public static Crossed Geometric(Lab lab, Sphere s, Vector3 d, Func<double, double, double, Crossed>? roots = null)
    {
        var L = s.Center - lab.P;
        var tca = L * d;
        var D2 = L * L - tca * tca;
        return roots is null ? Roots(tca, Math.Sqrt(s.Radius * s.Radius - D2)) : roots(s.Radius, tca, D2);
    }

    /// <summary>Slide "Sphere – Analytical Solution": the roots of a t² + b t + c = 0, from its discriminant.</summary>
    public static Crossed Roots(double a, double b, double discriminant) =>
        new((-b - Math.Sqrt(discriminant)) / (2 * a), (-b + Math.Sqrt(discriminant)) / (2 * a));

    /// <summary>The three slabs of a box and what they share.</summary>
    /// <param name="lab">Where the ray starts.</param>
    /// <param name="box">The box.</param>
    /// <param name="d">The ray's direction.</param>
    /// <param name="slab">(lo, hi, origin, direction) → the ways in and out of a slab.</param>
    /// <param name="lastIn">Of the ways in of x, y and z the one that counts.</param>
    /// <param name="firstOut">Of the ways out of x, y and z the one that counts.</param>
    public static Crossed Slabs(
        Lab lab, Aabb box, Vector3 d, InSlab slab, Func<double, double, double, double> lastIn, Func<double, double, double, double> firstOut) =>
        Slabs(lab, box, d, (slab, slab, slab), lastIn, firstOut);

    /// <summary>The same with a formula for each slab, and perhaps with another question than t_min ≤ t_max.</summary>
    public static Crossed Slabs(Lab lab, Aabb box, Vector3 d, (InSlab X, InSlab Y, InSlab Z) slabs,
        Func<double, double, double, double> lastIn, Func<double, double, double, double> firstOut, Func<double, double, bool>? isHit = null)
    {
        var x = slabs.X(box.Min.X, box.Max.X, lab.P.X, d.X);
        var y = slabs.Y(box.Min.Y, box.Max.Y, lab.P.Y, d.Y);
        var z = slabs.Z(box.Min.Z, box.Max.Z, lab.P.Z, d.Z);
        var (tMin, tMax) = (lastIn(x.In, y.In, z.In), firstOut(x.Out, y.Out, z.Out));
        return (isHit?.Invoke(tMin, tMax) ?? tMin <= tMax) ? new(tMin, tMax) : None;
    }

    /// <summary>The greatest of three; no number if one is none.</summary>
    public static double Greatest(double x, double y, double z) => Math.Max(Math.Max(x, y), z);

    /// <summary>The least of three; no number if one is none.</summary>
    public static double Least(double x, double y, double z) => Math.Min(Math.Min(x, y), z);

    /// <summary>(lo, hi, origin, direction) → the ways in and out of a slab.</summary>
    public delegate (double In, double Out) InSlab(double lo, double hi, double origin, double direction);

    /// <summary>One slab: t0 and t1 sorted; a ray along it is in it for ever or never, on its face too.</summary>
    public static (double In, double Out) Slab(double lo, double hi, double origin, double direction) =>
        direction == 0 ? AlongSlab(lo, hi, origin) : Sorted((lo - origin) / direction, (hi - origin) / direction);

    /// <summary>One slab: t0 at its lower face, t1 at its upper one.</summary>
    public static (double In, double Out) Faces(double lo, double hi, double origin, double direction) =>
        direction == 0 ? AlongSlab(lo, hi, origin) : ((lo - origin) / direction, (hi - origin) / direction);

    /// <summary>A slab that the ray runs along.</summary>
    private static (double In, double Out) AlongSlab(double lo, double hi, double origin) => lo <= origin && origin <= hi
        ? (double.NegativeInfinity, double.PositiveInfinity)
        : (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>The lesser first; no number if one is none.</summary>
    public static (double, double) Sorted(double t0, double t1) => (Math.Min(t0, t1), Math.Max(t0, t1));

    /// <summary>Slide "Triangle": n = (B − A) × (C − A), u and v are shares of its length.</summary>
    /// <param name="lab">Whose cross product is used.</param>
    /// <param name="triangle">The triangle.</param>
    /// <param name="d">The ray's direction.</param>
    /// <param name="inside">(u, v) → whether X is in the triangle.</param>
    /// <param name="crossing">(A, n) → the t where the ray crosses the triangle's plane; the right one if left out.</param>
    /// <param name="sides">The cross product of u and v; the lab's if left out.</param>
    /// <param name="at">t → X; P + t d if left out.</param>
    public static Crossed Triangle(
        Lab lab, Triangle triangle, Vector3 d, Func<double, double, bool> inside, Func<Vector3, Vector3, double>? crossing = null,
        Func<Vector3, Vector3, Vector3>? sides = null, Func<double, Vector3>? at = null)
    {
        var (A, B, C) = (triangle.A, triangle.B, triangle.C);
        var (n, t) = CrossPlane(lab, triangle, d);
        if (crossing is not null) t = crossing(A, n);
        if (!lab.Counts(t, d)) return None; // only to be done sooner
        var X = at?.Invoke(t) ?? lab.P + t * d;
        if (sides is null) sides = lab.Cross.Do;
        else n = sides(B - A, C - A);
        var u = sides(A - C, X - C) * n / (n * n);
        var v = sides(B - A, X - A) * n / (n * n);
        return inside(u, v) ? new(t) : None;
    }

    /// <summary>The same as the hand-out has it: w, u and v are shares of the volumes that d spans with the corners seen from P.</summary>
    public static Crossed TriangleByVolumes(Lab lab, Triangle triangle, Vector3 d, Vector3? from = null, Vector3? signs = null,
        Func<double, double, double, bool>? inside = null)
    {
        var (_, t) = CrossPlane(lab, triangle, d);
        if (!lab.Counts(t, d)) return None;
        var (P, sign) = (from ?? lab.P, signs ?? new(1, 1, 1));
        var (a, b, c) = (triangle.A - P, triangle.B - P, triangle.C - P);
        var (w, u, v) = (sign.X * (d * lab.Cross.Do(b, c)), sign.Y * (d * lab.Cross.Do(c, a)), sign.Z * (d * lab.Cross.Do(a, b)));
        var sum = w + u + v;
        return inside?.Invoke(u, v, sum) ?? (w / sum >= 0 && u / sum >= 0 && v / sum >= 0) ? new(t) : None;
    }

    /// <summary>Whether u and v are those of a point in the triangle.</summary>
    public static bool IsInside(double u, double v) => u >= 0 && v >= 0 && u + v <= 1;

    /// <summary>The areas of the triangles that X makes with the sides add up to the triangle's, where X is in it.</summary>
    public static Crossed TriangleByAreas(Lab lab, Triangle triangle, Vector3 d)
    {
        var (A, B, C) = (triangle.A, triangle.B, triangle.C);
        var (n, t) = CrossPlane(lab, triangle, d);
        var X = lab.P + t * d;
        double Area(Vector3 a, Vector3 b) => lab.Length.Do(lab.Cross.Do(a, b));
        return Area(C - B, X - B) + Area(A - C, X - C) + Area(B - A, X - A) == lab.Length.Do(n) ? new(t) : None;
    }

    /// <summary>n, and the t where the ray crosses the triangle's plane.</summary>
    private static (Vector3 N, double T) CrossPlane(Lab lab, Triangle triangle, Vector3 d)
    {
        var n = lab.Cross.Do(triangle.B - triangle.A, triangle.C - triangle.A);
        return (n, (triangle.A - lab.P) * n / (d * n));
    }
}
