namespace RayCaster.Teaching;

/// <summary>The reasons for outcomes, in words for students.</summary>
internal static class Reasons
{
    /// <summary>Why a crossing does not count.</summary>
    public static string Of(Outcome outcome, double t, double z, Camera camera) => outcome switch
    {
        Outcome.Behind => $"t = {Digits.Of(t)} < 0: behind the camera",
        Outcome.UnderBias => Compare("t", t, "≤", "bias", camera.Bias) + ": too near to where the ray starts",
        Outcome.BeforeNear => Compare("z", z, "<", "zNear", camera.ZNear) + ": clipped away, nearer than the near plane",
        Outcome.BeyondFar => Compare("z", z, ">", "zFar", camera.ZFar) + ": clipped away, beyond the far plane",
        _ => "counts",
    };

    /// <summary>Why a ray does not cross a model, in the slides' words for the slides' shapes.</summary>
    /// <param name="model">The model, or a triangle of a mesh.</param>
    /// <param name="near">The crossing, which is NaN.</param>
    public static string NoCrossing(Model model, IReadOnlyList<FormulaStep> steps, Term near) => model switch
    {
        Model<Plane> => "d·n = 0: the ray runs along the plane",
        Model<Sphere> { Primitive: var sphere } when Find(steps, "D") is { } D && D.Vector.Length > sphere.Radius =>
            Compare("|D|", D.Vector.Length, ">", "R", sphere.Radius) + ": the ray passes the sphere by",
        Model<Circle> { Primitive: var circle } => Circle(circle, steps) ?? Why.IsNoNumber(near),
        Model<Aabb> when (Find(steps, "t_min"), Find(steps, "t_max")) is ({ } tMin, { } tMax) => Box(steps, tMin.Value, tMax.Value),
        Model<Triangle> when Weights(steps) is [var w, var u, var v] => Triangle(w, u, v) ?? Why.IsNoNumber(near),
        Model<Triangle> => "d·n = 0: the triangle is seen edge-on",
        _ => Why.IsNoNumber(near),
    };

    /// <summary>The barycentric numbers w, u, v of a triangle, which add up to 1; null for a triangle seen edge-on.</summary>
    public static IReadOnlyList<double>? Weights(IReadOnlyList<FormulaStep> steps)
    {
        if ((Find(steps, "w"), Find(steps, "u"), Find(steps, "v")) is not ({ } w, { } u, { } v)) return null;
        var sum = w.Value + u.Value + v.Value;
        return sum != 0 && double.IsFinite(sum) ? [w.Value / sum, u.Value / sum, v.Value / sum] : null;
    }

    /// <summary>"|X − C| = 2.3 > R = 2", with enough digits to show the difference.</summary>
    public static string Compare(string left, double a, string sign, string right, double b)
    {
        var (first, second) = Digits.Apart(a, b);
        return $"{left} = {first} {sign} {right} = {second}";
    }

    public static FormulaStep? Find(IReadOnlyList<FormulaStep> steps, string name) => steps.FirstOrDefault(step => step.Name == name);

    public static double[] Values(IReadOnlyList<FormulaStep> steps, string name) =>
        [.. steps.Where(step => step.Name == name).Select(step => step.Value)];

    /// <summary>Where a ray enters and leaves the slabs of a box: the lesser and the greater of t0 and t1. NaN, for a ray within a face of a slab,
    /// becomes −∞ and +∞: the ray is always in that slab.</summary>
    public static (double[] Enters, double[] Leaves) Slabs(double[] t0, double[] t1) => (
        [.. t0.Zip(t1, (a, b) => Math.Min(a, b) is var t && double.IsNaN(t) ? double.NegativeInfinity : t)],
        [.. t0.Zip(t1, (a, b) => Math.Max(a, b) is var t && double.IsNaN(t) ? double.PositiveInfinity : t)]);

    private static string? Circle(Circle circle, IReadOnlyList<FormulaStep> steps)
    {
        if (Find(steps, "t") is not { } t || !double.IsFinite(t.Value)) return "d·n = 0: the ray runs along the circle's plane";
        return Find(steps, "CX") is { } CX && CX.Vector.Length > circle.Radius
            ? Compare("|X − C|", CX.Vector.Length, ">", "R", circle.Radius) + ": outside the circle"
            : null;
    }

    private static string Box(IReadOnlyList<FormulaStep> steps, double tMin, double tMax)
    {
        var (enters, leaves) = Slabs(Values(steps, "t0"), Values(steps, "t1"));
        var (entered, left) = (Array.IndexOf(enters, tMin), Array.IndexOf(leaves, tMax));
        var compared = Compare("t_min", tMin, ">", "t_max", tMax);
        if (entered < 0 || left < 0) return compared + ": the ray passes the box by";
        return entered == left
            ? $"{compared}: the ray runs beside the {"xyz"[entered]} slab, never in it"
            : $"{compared}: it leaves the {"xyz"[left]} slab before it enters the {"xyz"[entered]} slab";
    }

    private static string? Triangle(double w, double u, double v)
    {
        var failed = new List<string>();
        if (u < 0) failed.Add($"u = {Digits.Of(u)} < 0");
        if (v < 0) failed.Add($"v = {Digits.Of(v)} < 0");
        if (w < 0) failed.Add(u + v > 1 ? $"u + v = {Digits.Apart(u + v, 1).A} > 1" : $"w = {Digits.Of(w)} < 0");
        return failed.Count == 0 ? null : string.Join(" and ", failed) + ": outside the triangle";
    }
}
