using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>
/// The slides' own algebra of a sphere, a box and a triangle, in steps. A shape is drawn by it as soon as a mistake changes one of its
/// steps, so that two mistakes in one formula add up; right as it stands here, but for rounding.
/// </summary>
internal sealed partial class Lab
{
    // ---- Slide "Sphere – Geometric Solution", for d·d = 1 ----

    /// <summary>Whether it is never asked if a ray passes a sphere by.</summary>
    public bool NeverPassesBy { get; set; }

    /// <summary>(R, D²) → thc².</summary>
    public Step<Func<double, double, double>> Thc2 => field ??= new((R, D2) => R * R - D2);

    /// <summary>That → thc.</summary>
    public Step<Func<double, double>> Thc => field ??= new(Math.Sqrt);

    /// <summary>(tca, thc) → the crossings.</summary>
    public Step<Func<double, double, Crossed>> Roots => field ??= new((tca, thc) => new(tca - thc, tca + thc));

    // ---- Slide "Sphere – Analytical Solution": a t² + b t + c = 0 ----

    /// <summary>(a, b, c) → b² − 4ac.</summary>
    public Step<Func<double, double, double, double>> Discriminant => field ??= new((a, b, c) => b * b - 4 * a * c);

    // ---- Slides "AABB …" ----

    /// <summary>(axis, box, d) → t0 and t1, where the ray crosses the two faces across an axis: 0 is x, 1 is y, 2 is z.</summary>
    public Step<Func<int, Aabb, Vector3, (double T0, double T1)>> Faces => field ??= new(FacesOf);

    /// <summary>(t0, t1) → the way into that slab and the way out.</summary>
    public Step<Func<double, double, (double In, double Out)>> Order => field ??=
        new((t0, t1) => (Math.Min(t0, t1), Math.Max(t0, t1))); // no number if one is none

    /// <summary>The ways into x, y and z → the one that counts.</summary>
    public Step<Func<double, double, double, double>> LastIn => field ??= new((x, y, z) => Math.Max(Math.Max(x, y), z));

    // ---- Slide "Triangle" ----

    /// <summary>n → what u and v are divided by.</summary>
    public Step<Func<Vector3, double>> Whole => field ??= new(n => n * n);

    /// <summary>(u, v) → whether X is in the triangle.</summary>
    public Step<Func<double, double, bool>> Inside => field ??= new((u, v) => u >= 0 && v >= 0 && u + v <= 1);

    /// <summary>The way a triangle is hit; the definition's if null.</summary>
    public Func<Triangle, Vector3, Crossed>? TriangleFormula { get; set; }

    /// <summary>The sphere's formula as its steps are now.</summary>
    public Crossed SphereBySteps(Sphere s, Vector3 d) =>
        Thc2.IsChanged || Thc.IsChanged || Roots.IsChanged ? Geometric(s, d) : Discriminant.IsChanged ? Analytical(s, d) : s.Intersect(RayOf(d));

    /// <summary>Puts a formula in the place of the triangle's that may hit it outside of itself.</summary>
    public void TriangleIs(Func<Triangle, Vector3, Crossed> formula) => (TriangleFormula, TrianglesReachOut) = (formula, true);

    /// <summary>L, tca, D², thc.</summary>
    public Crossed Geometric(Sphere s, Vector3 d) => Geometric(s, d, (L, tca) => L * L - tca * tca);

    /// <param name="DSquare">(L, tca) → D².</param>
    public Crossed Geometric(Sphere s, Vector3 d, Func<Vector3, double, double> DSquare)
    {
        var L = s.Center - P;
        var tca = L * d;
        var D2 = DSquare(L, tca);
        var thc = Thc.Do(Thc2.Do(s.Radius, D2));
        return (!NeverPassesBy && D2 > (double)s.Radius * s.Radius) || double.IsNaN(thc) ? SlideFormulas.None : Roots.Do(tca, thc);
    }

    /// <summary>a, b, c, the discriminant.</summary>
    private Crossed Analytical(Sphere s, Vector3 d)
    {
        var (a, b, L) = (d * d, 2 * (d * (P - s.Center)), P - s.Center);
        var root = Math.Sqrt(Discriminant.Do(a, b, L * L - (double)s.Radius * s.Radius));
        return new((-b - root) / (2 * a), (-b + root) / (2 * a));
    }

    /// <summary>t_min = the last way in, t_max = the first way out.</summary>
    private Crossed Slabs(Aabb box, Vector3 d)
    {
        var (x, y, z) = (SlabOf(0), SlabOf(1), SlabOf(2));
        var (tMin, tMax) = (LastIn.Do(x.In, y.In, z.In), Math.Min(Math.Min(x.Out, y.Out), z.Out));
        return tMin <= tMax ? new(tMin, tMax) : SlideFormulas.None;

        (double In, double Out) SlabOf(int axis) => Faces.Do(axis, box, d) is var (t0, t1) ? Order.Do(t0, t1) : default;
    }

    /// <summary>Where a ray crosses the faces of a slab; of a ray parallel to it, all is in it or none, on its face too.</summary>
    private (double, double) FacesOf(int axis, Aabb box, Vector3 d)
    {
        var (lo, hi, origin, direction) = (box.Min.At(axis), box.Max.At(axis), P.At(axis), d.At(axis));
        return direction != 0 ? ((lo - origin) / direction, (hi - origin) / direction)
            : lo <= origin && origin <= hi ? (double.NegativeInfinity, double.PositiveInfinity)
            : (double.NaN, double.NaN);
    }

    /// <summary>n = (B − A) × (C − A), u and v are shares of its length.</summary>
    public Crossed TriangleByShares(Triangle triangle, Vector3 d)
    {
        var (A, B, C, n) = (triangle.A, triangle.B, triangle.C, NormalOf(triangle));
        var t = (A - P) * n / (d * n);
        if (!Counts(t, d)) return SlideFormulas.None; // only to be done sooner
        var (X, whole) = (P + t * d, Whole.Do(n));
        return Inside.Do(Cross.Do(A - C, X - C) * n / whole, Cross.Do(B - A, X - A) * n / whole) ? new(t) : SlideFormulas.None;
    }

    /// <summary>The areas of the triangles that X makes with the sides are in sum that of the triangle, where X is in it.</summary>
    public Crossed TriangleByAreas(Triangle triangle, Vector3 d)
    {
        var (A, B, C, n) = (triangle.A, triangle.B, triangle.C, NormalOf(triangle));
        var t = (A - P) * n / (d * n);
        var X = P + t * d;
        return Area(C - B, X - B) + Area(A - C, X - C) + Area(B - A, X - A) == Length.Do(n) ? new(t) : SlideFormulas.None;

        double Area(Vector3 a, Vector3 b) => Length.Do(Cross.Do(a, b));
    }

    /// <summary>(B − A) × (C − A).</summary>
    public Vector3 NormalOf(Triangle triangle) => Cross.Do(triangle.B - triangle.A, triangle.C - triangle.A);
}
