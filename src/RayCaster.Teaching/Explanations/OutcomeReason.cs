namespace RayCaster.Teaching.Explanations;

/// <summary>The reasons for outcomes, in words for students.</summary>
internal static class OutcomeReason
{
    /// <summary>Why a crossing does not count.</summary>
    public static string Format(Outcome refusal, double t, PixelExplanation pixel)
    {
        var z = t * pixel.Ray.DepthPerT;
        var camera = pixel.Scene.Camera;
        return refusal switch
        {
            Outcome.Behind => $"t = {Digits.Format(t)} < 0: behind the camera",
            Outcome.UnderBias => Compare("t", t, "≤", "bias", camera.Bias) + ": too near to where the ray starts",
            Outcome.BeforeNear => Compare("z", z, "<", "zNear", camera.ZNear) + ": clipped away, nearer than the near plane",
            _ => Compare("z", z, ">", "zFar", camera.ZFar) + ": clipped away, beyond the far plane",
        };
    }

    /// <summary>Why a ray does not cross a model, in the slides' words for the slides' shapes.</summary>
    /// <param name="model">The model, or a triangle of a mesh.</param>
    /// <param name="slabs">Those of a box.</param>
    /// <param name="near">The crossing, which is NaN.</param>
    public static string NoCrossing(Model model, IReadOnlyList<NamedValue> steps, IReadOnlyList<SlabExplanation> slabs, Term near) =>
        model switch
        {
            Model<Plane> => "d·n = 0: the ray runs along the plane",
            Model<Circle> when Find(steps, "t") is not double t || !double.IsFinite(t) => "d·n = 0: the ray runs along the circle's plane",
            Model<Circle> { Primitive.Radius: var R } => Beyond(R, "|X − C|", Find(steps, "CX"), "outside the circle"),
            Model<Sphere> { Primitive.Radius: var R } => Beyond(R, "|D|", Find(steps, "D"), "the ray misses the sphere"),
            Model<Aabb> when (Find(steps, "t_min"), Find(steps, "t_max")) is (double tMin, double tMax) =>
                $"{Compare("t_min", tMin, ">", "t_max", tMax)}: {BesideSlabs(slabs, tMin, tMax)}",
            Model<Triangle> => Weights(steps) is [var w, var u, var v] ? Outside(w, u, v) : "d·n = 0: the triangle is seen edge-on",
            _ => null,
        } ?? NaNReason.IsNoNumber(near);

    /// <summary>The barycentric numbers w, u, v of a triangle, which add up to 1; null for a triangle seen edge-on.</summary>
    public static IReadOnlyList<double>? Weights(IReadOnlyList<NamedValue> steps)
    {
        if ((Find(steps, "w"), Find(steps, "u"), Find(steps, "v")) is not (double w, double u, double v)) return null;
        var sum = w + u + v;
        return sum != 0 && double.IsFinite(sum) ? [w / sum, u / sum, v / sum] : null;
    }

    /// <summary>"|X − C| = 2.3 > R = 2", with enough digits to show the difference.</summary>
    public static string Compare(string left, double a, string sign, string right, double b)
    {
        var (first, second) = Digits.Apart(a, b);
        return $"{left} = {first} {sign} {right} = {second}";
    }

    private static object? Find(IReadOnlyList<NamedValue> steps, string name) => steps.FirstOrDefault(step => step.Name == name)?.Value;

    private static string? Beyond(double R, string name, object? distance, string reason) =>
        distance is Vector3 { Length: var length } && length > R ? $"{Compare(name, length, ">", "R", R)}: {reason}" : null;

    private static string BesideSlabs(IReadOnlyList<SlabExplanation> slabs, double tMin, double tMax)
    {
        var entered = slabs.FirstOrDefault(slab => slab.Enters == tMin);
        var left = slabs.FirstOrDefault(slab => slab.Leaves == tMax);
        return entered is null || left is null ? "the ray misses the box"
            : entered == left ? $"the ray runs beside the {entered.Axis} slab, never in it"
            : $"it leaves the {left.Axis} slab before it enters the {entered.Axis} slab";
    }

    private static string? Outside(double w, double u, double v)
    {
        var failed = new List<string>();
        if (u < 0) failed.Add($"u = {Digits.Format(u)} < 0");
        if (v < 0) failed.Add($"v = {Digits.Format(v)} < 0");
        if (w < 0) failed.Add(u + v > 1 ? $"u + v = {Digits.Apart(u + v, 1).A} > 1" : $"w = {Digits.Format(w)} < 0");
        return failed.Count == 0 ? null : string.Join(" and ", failed) + ": outside the triangle";
    }
}
