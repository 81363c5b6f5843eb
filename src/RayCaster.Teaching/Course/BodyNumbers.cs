namespace RayCaster.Teaching.Course;

/// <summary>The right numbers on the way to a shape's t, in the letters of the hand-out's README, and one's own as far as the calls of Hit tell
/// them.</summary>
public static class BodyNumbers
{
    /// <summary>The numbers of a ray and a model, a double or a vector each, in the order in which a body computes them; none for a mesh.</summary>
    /// <param name="analytical">A sphere's by its analytical solution.</param>
    public static IReadOnlyList<(string Name, object Value)> Of(Model model, Vector3 P, Vector3 d, bool analytical = false) => model switch
    {
        Model<Plane> { Primitive: var (Q, n) } => [("(Q − P)·n", (Q - P) * n), .. OfPlane(Q, n, P, d).Take(2)],
        Model<Circle> { Primitive: var (C, n, R) } =>
            [.. OfPlane(C, n, P, d), .. d * n == 0 ? [] : ((string, object)[])[("|X − C|", (At(C, n, P, d) - C).Length), ("R", R)]],
        Model<Sphere> { Primitive: var s } => analytical ? Analytical(s, P, d) : Geometric(s, P, d),
        Model<Aabb> { Primitive: var box } => OfBox(box, P, d),
        Model<Triangle> { Primitive: var triangle } => OfTriangle(triangle, P, d),
        _ => [],
    };

    /// <summary>The same in a line.</summary>
    public static string Line(Model model, Vector3 P, Vector3 d, bool analytical = false) =>
        string.Join(", ", Of(model, P, d, analytical).Select(number => $"{number.Name} = {Text(number.Value)}"));

    /// <summary>Where a ray enters and leaves a slab along an axis.</summary>
    internal static (double In, double Out) Slab(double B0, double B1, double P, double d) =>
        d != 0 ? (Math.Min((B0 - P) / d, (B1 - P) / d), Math.Max((B0 - P) / d, (B1 - P) / d))
        : B0 <= P && P <= B1 ? (double.NegativeInfinity, double.PositiveInfinity)
        : (double.PositiveInfinity, double.NegativeInfinity);

    /// <summary>One's own numbers, by their names.</summary>
    /// <param name="right">The right ones.</param>
    /// <param name="calls">The t with which Hit was called.</param>
    /// <param name="slabs">Of a box: x0, x1, y0, y1, z0 and z1 by Slab, then by Intersect of a box that is endless along the other axes.</param>
    internal static IEnumerable<(string Name, object Value)> Yours(IReadOnlyList<(string Name, object Value)> right, double[] calls, double[]? slabs)
    {
        if (slabs is { Length: 12 })
        {
            // If just one axis is wrong in Intersect, its line there is, in which Slab is called.
            int[] wrong = [.. Enumerable.Range(0, 6).Where(i => !IsSame(slabs[6 + i], right[i].Value)).Select(i => i / 2).Distinct()];
            for (var i = 0; i < 6; i++) yield return (right[i].Name, slabs[wrong is [var axis] && axis == i / 2 ? 6 + i : i]);
        }
        if (calls is [var only]) yield return ("t", only);
        if (calls is not [var a, var b]) yield break;
        var (near, far) = (Math.Min(a, b), Math.Max(a, b));
        foreach (var number in ((string, object)[])[(TMin, a), (TMax, b), (Near, near), (Far, far), (AnalyticalNear, near), (AnalyticalFar, far)])
            yield return number;
        // Two roots tell t_ca and t_hc, if not just one of the two is wrong: then it is the line of that one.
        if (RootsOf(right) is var (first, second) && (IsSame(near, first) || IsSame(far, second))) yield break;
        foreach (var number in ((string, object)[])[("t_ca", (near + far) / 2), ("t_hc", (far - near) / 2),
            (MinusB, (near + far) / 2), (Root, (far - near) / 2)]) yield return number;
    }

    /// <summary>The two crossings among right numbers; null if there are not two.</summary>
    internal static (double Near, double Far)? RootsOf(IReadOnlyList<(string Name, object Value)> right) =>
        right is [.., (Near or AnalyticalNear or TMin, double near), (_, double far)] && near <= far ? (near, far) : null;

    /// <summary>Which of the slabs' numbers a wrong t_min or t_max is.</summary>
    internal static string Which(IReadOnlyList<(string Name, object Value)> right, string name, object own) => name is not (TMin or TMax) ? ""
        : right.Take(6).FirstOrDefault(number => IsSame(number.Value, own)).Name is { } slab ? $", which is {slab}" : ", which is none of x0 … z1";

    private const string TMin = "t_min", TMax = "t_max";

    private const string Near = "t_ca − t_hc", Far = "t_ca + t_hc", MinusB = "−b / (2a)", Root = "√(b² − 4ac) / (2a)",
        AnalyticalNear = MinusB + " − " + Root, AnalyticalFar = MinusB + " + " + Root;

    internal static string Text(object value) => value is Vector3 vector ? Digits.Format(vector) : Digits.Format((double)value);

    internal static bool IsSame(object a, object b) => (a, b) switch
    {
        (double x, double y) => x.Equals(y) || double.IsFinite(x - y) && Math.Abs(x - y) <= 1e-6 * (1 + Math.Min(Math.Abs(x), Math.Abs(y))),
        (Vector3 v, Vector3 w) => IsSame(v.X, w.X) && IsSame(v.Y, w.Y) && IsSame(v.Z, w.Z),
        _ => false,
    };

    private static Vector3 At(Vector3 Q, Vector3 n, Vector3 P, Vector3 d) => P + (Q - P) * n / (d * n) * d;

    private static (string, object)[] OfPlane(Vector3 Q, Vector3 n, Vector3 P, Vector3 d) => d * n == 0 ? [("d·n", d * n)]
        : [("d·n", d * n), ("t", (Q - P) * n / (d * n)), ("X", At(Q, n, P, d))];

    private static List<(string, object)> Geometric(Sphere sphere, Vector3 P, Vector3 d)
    {
        var (C, R) = sphere;
        var L = C - P;
        var t_ca = L * d;
        var D2 = (L - t_ca * d) * (L - t_ca * d); // L² − t_ca² without loss of digits
        List<(string, object)> numbers = [("L", L), ("t_ca", t_ca), ("D²", D2), ("R²", R * R)];
        var t_hc = Math.Sqrt(R * R - D2);
        return D2 > R * R ? numbers : [.. numbers, ("t_hc", t_hc), (Near, t_ca - t_hc), (Far, t_ca + t_hc)];
    }

    private static List<(string, object)> Analytical(Sphere sphere, Vector3 P, Vector3 d)
    {
        var (C, R) = sphere;
        var (a, b, c) = (d * d, 2 * (d * (P - C)), (P - C) * (P - C) - R * R);
        List<(string, object)> numbers = [("a", a), ("b", b), ("c", c), ("b² − 4ac", b * b - 4 * a * c)];
        var (middle, root) = (-b / (2 * a), Math.Sqrt(b * b - 4 * a * c) / (2 * a));
        return double.IsNaN(root) ? numbers
            : [.. numbers, (MinusB, middle), (Root, root), (AnalyticalNear, middle - root), (AnalyticalFar, middle + root)];
    }

    private static (string, object)[] OfBox(Aabb box, Vector3 P, Vector3 d)
    {
        var (B0, B1) = box;
        var ((x0, x1), (y0, y1), (z0, z1)) = (Slab(B0.X, B1.X, P.X, d.X), Slab(B0.Y, B1.Y, P.Y, d.Y), Slab(B0.Z, B1.Z, P.Z, d.Z));
        return [("x0", x0), ("x1", x1), ("y0", y0), ("y1", y1), ("z0", z0), ("z1", z1),
            (TMin, Math.Max(x0, Math.Max(y0, z0))), (TMax, Math.Min(x1, Math.Min(y1, z1)))];
    }

    private static (string, object)[] OfTriangle(Triangle triangle, Vector3 P, Vector3 d)
    {
        var (A, B, C) = triangle;
        var n = (B - A) % (C - A);
        if (d * n == 0) return [("n", n), ("d·n", d * n)];
        var X = At(A, n, P, d);
        var (u, v) = ((A - C) % (X - C) * n / (n * n), (B - A) % (X - A) * n / (n * n));
        return [("n", n), .. OfPlane(A, n, P, d), ("u", u), ("v", v), ("u + v", u + v)];
    }
}
