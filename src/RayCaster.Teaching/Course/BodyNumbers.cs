using Numbers = System.Collections.Generic.IReadOnlyList<(string Name, object Value)>;

namespace RayCaster.Teaching.Course;

/// <summary>The numbers on the way to a shape's t, in the letters of the hand-out's README.</summary>
public static class BodyNumbers
{
    private const string Near = "t_ca − t_hc", Far = "t_ca + t_hc", Middle = "−b / (2a)", Half = "√(b² − 4ac) / (2a)",
        AnalyticalNear = Middle + " − " + Half, AnalyticalFar = Middle + " + " + Half, Enters = "t_min", Leaves = "t_max";

    /// <summary>The right numbers, in a line.</summary>
    /// <param name="analytical">A sphere's by its analytical solution.</param>
    public static string Line(Model model, Vector3 P, Vector3 d, bool analytical = false) =>
        string.Join(", ", Of(model, P, d, analytical).Select(number => $"{number.Name} = {Text(number.Value)}"));

    /// <summary>The right numbers, a double or a vector each, in the order in which a body computes them; none of a mesh.</summary>
    internal static Numbers Of(Model model, Vector3 P, Vector3 d, bool analytical) => model switch
    {
        Model<Plane> { Primitive: var (Q, n) } => [("(Q − P)·n", (Q - P) * n), .. OfPlane(Q, n, P, d, _ => [])],
        Model<Circle> { Primitive: var (C, n, R) } => OfPlane(C, n, P, d, X => [("X", X), ("|X − C|", (X - C).Length), ("R", R)]),
        Model<Sphere> { Primitive: var (C, R) } => analytical ? Analytical(P - C, R, d) : Geometric(C - P, R, d),
        Model<Aabb> { Primitive: var (B0, B1) } =>
            OfBox(Slab(B0.X, B1.X, P.X, d.X), Slab(B0.Y, B1.Y, P.Y, d.Y), Slab(B0.Z, B1.Z, P.Z, d.Z)),
        Model<Triangle> { Primitive: var (A, B, C) } => OfTriangle(A, B, C, P, d),
        _ => [],
    };

    /// <summary>Where a ray enters and leaves a slab along an axis.</summary>
    internal static (double In, double Out) Slab(double B0, double B1, double P, double d) =>
        d != 0 ? (Math.Min((B0 - P) / d, (B1 - P) / d), Math.Max((B0 - P) / d, (B1 - P) / d))
        : B0 <= P && P <= B1 ? (double.NegativeInfinity, double.PositiveInfinity)
        : (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>One's own numbers, as far as calls tell them.</summary>
    /// <param name="calls">The t with which Hit was called.</param>
    /// <param name="slabs">Of a box: x0, x1, y0, y1, z0 and z1 by Slab, then by Intersect of a box that is endless along the other axes.</param>
    internal static IEnumerable<(string Name, object Value)> Yours(Numbers right, double[] calls, double[] slabs)
    {
        // If just one axis is wrong in Intersect, its line there is, in which Slab is called.
        int[] wrong = [.. Enumerable.Range(0, slabs.Length / 2).Where(i => !IsSame(slabs[6 + i], right[i].Value)).Select(i => i / 2).Distinct()];
        for (var i = 0; i < slabs.Length / 2; i++) yield return (right[i].Name, slabs[wrong is [var axis] && axis == i / 2 ? 6 + i : i]);
        if (calls is [var only]) yield return ("t", only);
        if (calls is not [var a, var b]) yield break;
        var (near, far) = (Math.Min(a, b), Math.Max(a, b));
        foreach (var number in ((string, object)[])
            [(Near, near), (AnalyticalNear, near), (Far, far), (AnalyticalFar, far), (Enters, a), (Leaves, b)]) yield return number;
        // Two roots tell t_ca and t_hc, if not just one of the two is wrong: then it is the line of that one.
        if (RootsOf(right) is var (first, second) && (IsSame(near, first) || IsSame(far, second))) yield break;
        var (middle, half) = ((near + far) / 2, (far - near) / 2);
        foreach (var number in ((string, object)[])[("t_ca", middle), ("t_hc", half), (Middle, middle), (Half, half)]) yield return number;
    }

    /// <summary>The two crossings among right numbers; null if there are not two.</summary>
    internal static (double Near, double Far)? RootsOf(Numbers right) =>
        right is [.., (Near or AnalyticalNear or Enters, double near), (_, double far)] && near <= far ? (near, far) : null;

    /// <summary>Which of the slabs' numbers a wrong t_min or t_max is; and whether a slab's own one is of the axes that were endless.</summary>
    internal static string Which(Numbers right, string name, object own) => name is not (Enters or Leaves)
        ? own is > 1e7 or < -1e7 ? ", with a number of another axis" : ""
        : right.Take(6).FirstOrDefault(number => IsSame(number.Value, own)).Name is { } slab ? $", which is {slab}" : ", which is none of x0 … z1";

    internal static string Text(object value) => value is Vector3 vector ? Digits.Format(vector) : Digits.Format((double)value);

    internal static bool IsSame(object a, object b) => (a, b) switch
    {
        (double x, double y) => x.Equals(y) || (double.IsFinite(x - y) && Math.Abs(x - y) <= 1e-6 * (1 + Math.Min(Math.Abs(x), Math.Abs(y)))),
        (Vector3 v, Vector3 w) => IsSame(v.X, w.X) && IsSame(v.Y, w.Y) && IsSame(v.Z, w.Z),
        _ => false,
    };

    private static (string, object)[] OfPlane(Vector3 Q, Vector3 n, Vector3 P, Vector3 d, Func<Vector3, (string, object)[]> more)
    {
        var t = (Q - P) * n / (d * n);
        return d * n == 0 ? [("d·n", d * n)] : [("d·n", d * n), ("t", t), .. more(P + t * d)];
    }

    private static (string, object)[] Geometric(Vector3 L, double R, Vector3 d)
    {
        var t_ca = L * d;
        var D2 = (L - t_ca * d) * (L - t_ca * d); // L² − t_ca² without loss of digits
        var t_hc = Math.Sqrt(R * R - D2);
        return [("L", L), ("t_ca", t_ca), ("D²", D2), ("R²", R * R),
            .. D2 > R * R ? [] : ((string, object)[])[("t_hc", t_hc), (Near, t_ca - t_hc), (Far, t_ca + t_hc)]];
    }

    private static (string, object)[] Analytical(Vector3 CP, double R, Vector3 d)
    {
        var (a, b, c) = (d * d, 2 * (d * CP), CP * CP - R * R);
        var (middle, half) = (-b / (2 * a), Math.Sqrt(b * b - 4 * a * c) / (2 * a));
        return [("a", a), ("b", b), ("c", c), ("b² − 4ac", b * b - 4 * a * c), .. double.IsNaN(half) ? []
            : ((string, object)[])[(Middle, middle), (Half, half), (AnalyticalNear, middle - half), (AnalyticalFar, middle + half)]];
    }

    private static (string, object)[] OfBox((double, double) x, (double, double) y, (double, double) z) =>
        [("x0", x.Item1), ("x1", x.Item2), ("y0", y.Item1), ("y1", y.Item2), ("z0", z.Item1), ("z1", z.Item2),
            (Enters, Math.Max(x.Item1, Math.Max(y.Item1, z.Item1))), (Leaves, Math.Min(x.Item2, Math.Min(y.Item2, z.Item2)))];

    private static (string, object)[] OfTriangle(Vector3 A, Vector3 B, Vector3 C, Vector3 P, Vector3 d)
    {
        var n = (B - A) % (C - A);
        double u(Vector3 X) => (A - C) % (X - C) * n / (n * n);
        double v(Vector3 X) => (B - A) % (X - A) * n / (n * n);
        return [("n", n), .. OfPlane(A, n, P, d, X => [("X", X), ("u", u(X)), ("v", v(X)), ("u + v", u(X) + v(X))])];
    }
}
