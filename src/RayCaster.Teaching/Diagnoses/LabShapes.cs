using Crossed = RayCaster.Crossings<RayCaster.Scalar>;

namespace RayCaster.Teaching;

/// <summary>
/// The slides' own algebra of a sphere, a box and a triangle, in steps. A shape is drawn by it as soon as a mistake changes one of its
/// steps, so that two mistakes in one formula add up; right as it stands here, but for rounding.
/// </summary>
internal sealed partial class Lab
{
    // ---- Slide "Sphere – Geometric Solution", for d·d = 1 ----

    /// <summary>(L², tca) → D².</summary>
    public Step<Func<double, double, double>> D2 => field ??= new((L2, tca) => L2 - tca * tca);

    /// <summary>Whether it is never asked if a ray passes a sphere by.</summary>
    public bool NeverPassesBy { get; set; }

    /// <summary>(R, D²) → whether the ray passes the sphere by.</summary>
    public Step<Func<double, double, bool>> PassesBy => field ??= new((R, D2) => D2 > R * R);

    /// <summary>(R, D²) → thc².</summary>
    public Step<Func<double, double, double>> Thc2 => field ??= new((R, D2) => R * R - D2);

    /// <summary>That → thc.</summary>
    public Step<Func<double, double>> Thc => field ??= new(Math.Sqrt);

    /// <summary>(tca, thc) → the crossings.</summary>
    public Step<Func<double, double, Crossed>> Roots => field ??= new((tca, thc) => new(tca - thc, tca + thc));

    // ---- Slide "Sphere – Analytical Solution": a t² + b t + c = 0 ----

    /// <summary>(P, C) → the vector in b = 2 d·(P − C).</summary>
    public Step<Func<Vector3, Vector3, Vector3>> InB => field ??= new((P, C) => P - C);

    /// <summary>(P, C) → the vector in c = |P − C|² − R².</summary>
    public Step<Func<Vector3, Vector3, Vector3>> InC => field ??= new((P, C) => P - C);

    /// <summary>R → what is taken off in c.</summary>
    public Step<Func<double, double>> R2 => field ??= new(R => R * R);

    /// <summary>(a, b, c) → b² − 4ac.</summary>
    public Step<Func<double, double, double, double>> Discriminant => field ??= new((a, b, c) => b * b - 4 * a * c);

    /// <summary>(a, b, the discriminant) → the crossings.</summary>
    public Step<Func<double, double, double, Crossed>> Solution => field ??= new((a, b, D) =>
        new((-b - Math.Sqrt(D)) / (2 * a), (-b + Math.Sqrt(D)) / (2 * a)));

    // ---- Slides "AABB …" ----

    /// <summary>(axis, box, d) → t0 and t1, where the ray crosses the two faces across an axis: 0 is x, 1 is y, 2 is z.</summary>
    public Step<Func<int, Aabb, Vector3, (double T0, double T1)>> Faces => field ??= new(FacesOf);

    /// <summary>(axis, t0, t1, d) → the way into that slab and the way out.</summary>
    public Step<Func<int, double, double, Vector3, (double In, double Out)>> Order => field ??=
        new((_, t0, t1, _) => (Math.Min(t0, t1), Math.Max(t0, t1))); // no number if one is none

    /// <summary>(axis, box, d) → the same.</summary>
    public Step<Func<int, Aabb, Vector3, (double In, double Out)>> Slab => field ??= new((axis, box, d) =>
        Faces.Do(axis, box, d) is var (t0, t1) ? Order.Do(axis, t0, t1, d) : default);

    /// <summary>The ways into x, y and z → the one that counts.</summary>
    public Step<Func<double, double, double, double>> LastIn => field ??= new(SlideFormulas.Greatest);

    /// <summary>The ways out of x, y and z → the one that counts.</summary>
    public Step<Func<double, double, double, double>> FirstOut => field ??= new(SlideFormulas.Least);

    /// <summary>(t, d) → X, where each face is asked by itself.</summary>
    public Step<Func<double, Vector3, Vector3>> FaceX => field ??= new((t, d) => P + t * d);

    /// <summary>(t_min, t_max) → whether the ray hits the box.</summary>
    public Step<Func<double, double, bool>> Overlap => field ??= new((tMin, tMax) => tMin <= tMax);

    // ---- Slide "Triangle" ----

    /// <summary>(A, n, d) → the t where the ray crosses the triangle's plane.</summary>
    public Step<Func<Vector3, Vector3, Vector3, double>> TriangleT => field ??= new((A, n, d) => (A - P) * n / (d * n));

    /// <summary>(t, d) → X, whose u and v are asked.</summary>
    public Step<Func<double, Vector3, Vector3>> TriangleX => field ??= new((t, d) => P + t * d);

    /// <summary>n → what u and v are divided by.</summary>
    public Step<Func<Vector3, double>> Whole => field ??= new(n => n * n);

    /// <summary>(u, v) → whether X is in the triangle.</summary>
    public Step<Func<double, double, bool>> Inside => field ??= new(SlideFormulas.IsInside);

    /// <summary>The way a triangle is hit; the definition's if null.</summary>
    public Func<Triangle, Vector3, Crossed>? TriangleFormula { get; set; }

    /// <summary>The sphere's formula as its steps are now.</summary>
    public Crossed SphereBySteps(Sphere s, Vector3 d) => geometric ? Geometric(s, d) : analytical ? Analytical(s, d) : s.Intersect(RayOf(d));

    /// <summary>Puts a formula in the place of the triangle's that may hit it outside of itself.</summary>
    public void TriangleIs(Func<Triangle, Vector3, Crossed> formula) => (TriangleFormula, TrianglesReachOut) = (formula, true);

    /// <summary>L, tca, D², thc.</summary>
    /// <param name="D">(L, tca) → a vector as long as D, if D² is its square, as the hand-out has it; L² − tca² if null.</param>
    /// <param name="inTca">The vector in tca = L·d; L if null.</param>
    public Crossed Geometric(Sphere s, Vector3 d, Func<Vector3, double, Vector3>? D = null, Vector3? inTca = null)
    {
        var L = s.Center - P;
        var tca = (inTca ?? L) * d;
        var distance = D?.Invoke(L, tca) is { } ofLengthD ? D2.Do(ofLengthD * ofLengthD, 0) : D2.Do(L * L, tca);
        var thc = Thc.Do(Thc2.Do(s.Radius, distance));
        return (!NeverPassesBy && PassesBy.Do(s.Radius, distance)) || double.IsNaN(thc) ? SlideFormulas.None : Roots.Do(tca, thc);
    }

    /// <summary>a, b, c, the discriminant.</summary>
    private Crossed Analytical(Sphere s, Vector3 d)
    {
        var (a, b, toC) = (d * d, 2 * (d * InB.Do(P, s.Center)), InC.Do(P, s.Center));
        return Solution.Do(a, b, Discriminant.Do(a, b, toC * toC - R2.Do(s.Radius)));
    }

    /// <summary>t_min = the last way in, t_max = the first way out.</summary>
    private Crossed Slabs(Aabb box, Vector3 d)
    {
        var (x, y, z) = (Slab.Do(0, box, d), Slab.Do(1, box, d), Slab.Do(2, box, d));
        var (tMin, tMax) = (LastIn.Do(x.In, y.In, z.In), FirstOut.Do(x.Out, y.Out, z.Out));
        return Overlap.Do(tMin, tMax) ? new(tMin, tMax) : SlideFormulas.None;
    }

    /// <summary>Has each of the six faces asked by itself.</summary>
    /// <param name="asks">Whether a coordinate of X is asked, from the axis across the face and the coordinate's own; both others if null.</param>
    public void AskFaces(Func<int, int, bool>? asks = null)
    {
        var before = faceAsks;
        faceAsks = (axis, other) => before?.Invoke(axis, other) != false && asks?.Invoke(axis, other) != false;
    }

    /// <summary>The ray hits a face where the other two coordinates of X = P + t d lie between those of the corners.</summary>
    private Crossed ByFaces(Aabb box, Vector3 d)
    {
        var (near, far) = (double.PositiveInfinity, double.NegativeInfinity);
        for (var face = 0; face < 6; face++)
        {
            var (axis, (t0, t1)) = (face / 2, Faces.Do(face / 2, box, d));
            var t = face % 2 == 0 ? t0 : t1;
            var X = FaceX.Do(t, d); // no number along a slab
            if (IsBetween((axis + 1) % 3) && IsBetween((axis + 2) % 3)) (near, far) = (Math.Min(near, t), Math.Max(far, t));

            bool IsBetween(int other) => !faceAsks!(axis, other) || (box.Min.At(other) <= X.At(other) && X.At(other) <= box.Max.At(other));
        }
        return near <= far ? new(near, far) : SlideFormulas.None;
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
    public Crossed TriangleByShares(Triangle triangle, Vector3 d, Func<Vector3, Vector3, Vector3> sides)
    {
        var (A, B, C) = (triangle.A, triangle.B, triangle.C);
        var t = TriangleT.Do(A, NormalOf(triangle), d);
        if (!Counts(t, d)) return SlideFormulas.None; // only to be done sooner
        var (X, n) = (TriangleX.Do(t, d), sides(B - A, C - A));
        var whole = Whole.Do(n);
        return Inside.Do(sides(A - C, X - C) * n / whole, sides(B - A, X - A) * n / whole) ? new(t) : SlideFormulas.None;
    }

    /// <summary>The same with u = ((C − A) × n)·(X − A) / n·n and v = (n × (B − A))·(X − A) / n·n.</summary>
    public Crossed TriangleByCoordinates(Triangle triangle, Vector3 d)
    {
        var (b, c, n) = (triangle.B - triangle.A, triangle.C - triangle.A, NormalOf(triangle));
        var t = TriangleT.Do(triangle.A, n, d);
        if (!Counts(t, d)) return SlideFormulas.None;
        var (x, whole) = (TriangleX.Do(t, d) - triangle.A, Whole.Do(n));
        return Inside.Do(Cross.Do(c, n) * x / whole, Cross.Do(n, b) * x / whole) ? new(t) : SlideFormulas.None;
    }

    /// <summary>The same by Cramer's rule, as Möller and Trumbore have it: all from d × (C − A) and (P − A) × (B − A).</summary>
    public Crossed TriangleByDeterminants(Triangle triangle, Vector3 d)
    {
        var (b, c, p) = (triangle.B - triangle.A, triangle.C - triangle.A, P - triangle.A);
        var (dc, pb) = (Cross.Do(d, c), Cross.Do(p, b));
        var determinant = b * dc;
        return Inside.Do(p * dc / determinant, d * pb / determinant) ? new(c * pb / determinant) : SlideFormulas.None;
    }

    /// <summary>The same from n and (P − A) × d.</summary>
    public Crossed TriangleByRay(Triangle triangle, Vector3 d)
    {
        var (b, c, p, n) = (triangle.B - triangle.A, triangle.C - triangle.A, P - triangle.A, NormalOf(triangle));
        var q = Cross.Do(p, d);
        return Inside.Do(-(q * c) / (d * n), q * b / (d * n)) ? new(-(n * p) / (d * n)) : SlideFormulas.None;
    }

    /// <summary>The same as the hand-out has it: w, u and v are shares of the volumes that d spans with the corners seen from P.</summary>
    public Crossed TriangleByVolumes(Triangle triangle, Vector3 d, Vector3? from = null, Vector3? signs = null,
        Func<double, double, double, bool>? inside = null, bool tFromCorners = false)
    {
        var t = tFromCorners ? 0 : TriangleT.Do(triangle.A, NormalOf(triangle), d);
        if (!tFromCorners && !Counts(t, d)) return SlideFormulas.None;
        var (origin, sign) = (from ?? P, signs ?? new(1, 1, 1));
        var (a, b, c) = (triangle.A - origin, triangle.B - origin, triangle.C - origin);
        var (w, u, v) = (sign.X * (d * Cross.Do(b, c)), sign.Y * (d * Cross.Do(c, a)), sign.Z * (d * Cross.Do(a, b)));
        var sum = w + u + v;
        if (tFromCorners) t = (w * a + u * b + v * c) * d / (sum * (d * d));
        return inside?.Invoke(u, v, sum) ?? (w / sum >= 0 && u / sum >= 0 && v / sum >= 0) ? new(t) : SlideFormulas.None;
    }

    /// <summary>The areas of the triangles that X makes with the sides add up to the triangle's, where X is in it.</summary>
    /// <param name="slack">By how much the sum may be greater, as a share; null for not at all, nor less.</param>
    /// <param name="fromX">Whether each area is that between the ways from X to two corners, not between a side and the way to X.</param>
    public Crossed TriangleByAreas(Triangle triangle, Vector3 d, double? slack, bool fromX = false)
    {
        var ((A, B, C), n) = ((triangle.A, triangle.B, triangle.C), NormalOf(triangle));
        var t = TriangleT.Do(A, n, d);
        if (slack is not null && !Counts(t, d)) return SlideFormulas.None;
        var X = TriangleX.Do(t, d);
        var sum = fromX ? Area(B - X, C - X) + Area(C - X, A - X) + Area(A - X, B - X)
            : Area(C - B, X - B) + Area(A - C, X - C) + Area(B - A, X - A);
        var whole = Length.Do(n);
        return (slack is null ? sum == whole : sum <= (1 + slack) * whole) ? new(t) : SlideFormulas.None;

        double Area(Vector3 a, Vector3 b) => Length.Do(Cross.Do(a, b));
    }

    /// <summary>X lies on the same side of each of the triangle's sides as the corner that is opposite to it, or as n says.</summary>
    public Crossed TriangleBySides(Triangle triangle, Vector3 d, bool byNormal)
    {
        var (A, B, C, n) = (triangle.A, triangle.B, triangle.C, NormalOf(triangle));
        var t = TriangleT.Do(A, n, d);
        if (!Counts(t, d)) return SlideFormulas.None;
        var X = TriangleX.Do(t, d);
        return IsBeside(A, B, C) && IsBeside(B, C, A) && IsBeside(C, A, B) ? new(t) : SlideFormulas.None;

        bool IsBeside(Vector3 a, Vector3 b, Vector3 c) =>
            Cross.Do(b - a, X - a) * (byNormal ? n : Cross.Do(b - a, c - a)) >= 0;
    }

    /// <summary>u and v in the picture of the triangle along the axis that n is nearest to.</summary>
    public Crossed TriangleFlattened(Triangle triangle, Vector3 d)
    {
        var n = NormalOf(triangle);
        var (x, y, z) = (Math.Abs(n.X), Math.Abs(n.Y), Math.Abs(n.Z));
        var along = x >= y && x >= z ? new Vector3(1, 0, 0) : y >= z ? new(0, 1, 0) : new(0, 0, 1);
        return TriangleByShares(triangle, d, (a, b) => (a % b * along) * along);
    }

    /// <summary>(B − A) × (C − A).</summary>
    public Vector3 NormalOf(Triangle triangle) => Cross.Do(triangle.B - triangle.A, triangle.C - triangle.A);
}
