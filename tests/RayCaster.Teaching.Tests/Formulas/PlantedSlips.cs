using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>A slip that the catalogue of known mistakes does not have.</summary>
/// <param name="Section">The step in which it is made.</param>
/// <param name="What">What is written.</param>
internal sealed record Slip(string Section, string What, params Edit[] Edits);

/// <summary>
/// The lab with other formulas of the slides than those that it comes with: Pythagoras for the sphere, Möller–Trumbore for the triangle. It makes
/// one of some sixty slips.
/// </summary>
/// <param name="slip">A place in <see cref="All"/>; −1 for none.</param>
internal sealed class PlantedSlips(Scene scene, int slip)
{
    private static readonly Edit analytical = new("Sphere", "=> GeometricSolution", "=> AnalyticalSolution");

    private static readonly Planted otherFormulas = new("other formulas", "", [.. Pythagoras("t_ca * t_ca"), MollerTrumbore()]);

    public static readonly Slip[] All =
    [
        new("camera", "W = −(T − P) / |T|", new Edit("Camera", "(Target - Position).Normalized", "(Target - Position) / Target.Length")),
        new("camera", "V = W × up, not normalised", new Edit("Camera", "W % U", "W % Up")),
        new("camera", "fovY·π / 200", new Edit("Camera", "PI / 180", "PI / 200")),
        new("camera", "h = 2 sin(fovY / 2)", new Edit("Camera", "Math.Tan(fovY", "Math.Sin(fovY")),
        new("camera", "w = h √(width / height)", new Edit("Camera", "h * Width / Height;", "h * Math.Sqrt((double)Width / Height);")),
        new("camera", "w = h (width / height)²", new Edit("Camera", "h * Width / Height;", "h * Width / Height * Width / Height;")),
        new("camera", "w = h width / (height − 100)", new Edit("Camera", "h * Width / Height;", "h * Width / (Height - 100);")),
        new("camera", "h = 2 tan(fovY / 2)²", new Edit("Camera", "2 * Math.Tan(fovY / 2 * Math.PI / 180)",
            "2 * Math.Pow(Math.Tan(fovY / 2 * Math.PI / 180), 2)")),
        new("pixel", "uc = w c / width − h / 2", new Edit("Camera", "Width - w / 2", "Width - h / 2")),
        new("pixel", "ur = h r / height − w / 2", new Edit("Camera", "Height - h / 2", "Height - w / 2")),
        new("pixel", "uc = w c / height − w / 2", new Edit("Camera", "w * c / Width", "w * c / Height")),
        new("pixel", "uc = w c / width − w / 4", new Edit("Camera", "Width - w / 2", "Width - w / 4")),
        new("pixel", "d = uc U + ur V − 2 W", new Edit("Camera", "ur * V - W", "ur * V - 2 * W")),
        new("pixel", "d = uc U + ur U − W", new Edit("Camera", "ur * V - W", "ur * U - W")),
        new("pixel", "d = uc U + uc V − W", new Edit("Camera", "ur * V - W", "uc * V - W")),
        new("file", "r = height / 2 − y", new Edit("Scene", "= CastRay(c, r)", "= CastRay(c, r + 1 - Camera.Height / 2)")),
        new("plane", "t = (Q − P)·n / d·d", new Edit("Plane", "/ (ray.Direction * n)", "/ (ray.Direction * ray.Direction)")),
        new("plane", "t = (Q − P)·n · (d·n)", new Edit("Plane", "/ (ray.Direction * n)", "* (ray.Direction * n)")),
        new("plane", "t = |(Q − P)·n / d·n|", new Edit("Plane", "Hit(t, this)", "Hit(Math.Abs(t), this)")),
        new("plane", "t = (Q − T)·n / d·n", FromTarget("Plane", "Q - ray.Origin", "Q - Camera.T")),
        new("sphere", "L = C − T", FromTarget("Sphere", "C - ray.Origin", "C - Camera.T")),
        new("sphere", "t_ca = L·d / 2", new Edit("Sphere", "L * ray.Direction;", "L * ray.Direction / 2;")),
        new("sphere", "D² = L² − 2 t_ca²", Pythagoras("2 * t_ca * t_ca")),
        new("sphere", "t_hc = √(2 R² − D²)",
            new("Sphere", "D * D > R * R", "D * D > 2 * R * R"), new("Sphere", "Sqrt(R * R - D * D)", "Sqrt(2 * R * R - D * D)")),
        new("sphere", "t = (b ± √D) / 2 a, the sign of b lost", analytical, new("Sphere", "var b = 2", "var b = -2")),
        new("sphere", "D = b² + 4 a c", analytical, new("Sphere", "b * b - 4", "b * b + 4")),
        new("sphere", "t = t_ca − t_hc / 2", new Edit("Sphere", "t_ca - t_hc,", "t_ca - t_hc / 2,")),
        new("sphere", "L = C − d", new Edit("Sphere", "C - ray.Origin", "C - ray.Direction")),
        new("aabb", "(B − P) d for each slab", new("Aabb", "t0 = (B0 - P) / d", "t0 = (B0 - P) * d"), new("Aabb", "(B1 - P) / d", "(B1 - P) * d")),
        new("aabb", "B1.y for B0.y", new Edit("Aabb", "Slab(B0.Y", "Slab(B1.Y")),
        new("aabb", "d.y for d.x", new Edit("Aabb", "P.X, d.X", "P.X, d.Y")),
        new("aabb", "P.y for P.z", new Edit("Aabb", "P.Z, d.Z", "P.Y, d.Z")),
        new("aabb", "(B − T) / d for each slab", FromTarget("Aabb", "(ray.Origin, ray.Direction)", "(Camera.T, ray.Direction)")),
        new("aabb", "t = (tmin + tmax) / 2", new("Aabb", "Hit(t_min", "Hit((t_min + t_max) / 2"), new("Aabb", "ray.Hit(t_max, this);", "")),
        new("aabb", "tmin = max(x, y, −z)", new Edit("Aabb", "Max(y0, z0)", "Max(y0, -z0)")),
        new("circle", "|X| ≤ R", new Edit("Circle", "(X - C)", "X")),
        new("circle", "|X − P| ≤ R", new Edit("Circle", "(X - C)", "(X - ray.Origin)")),
        new("circle", "|X − C| ≤ √R", new Edit("Circle", "<= R", "<= Math.Sqrt(R)")),
        new("circle", "X = P + d", new Edit("Circle", "At(t)", "At(1)")),
        new("circle", "t = (P − C)·n / d·n", new Edit("Circle", "(C - ray.Origin)", "(ray.Origin - C)")),
        new("triangle", "C − B for C − A", MollerTrumbore(e2: "C - B")),
        new("triangle", "u v ≤ 1", MollerTrumbore(last: "u * v <= 1")),
        new("triangle", "u + v ≤ ½", MollerTrumbore(last: "u + v <= 0.5")),
        new("triangle", "n = B × C", Instead("""
            var (d, n) = (ray.Direction, B % C);
            var t = (A - ray.Origin) * n / (d * n);
            var X = ray.At(t);
            if (n * ((B - A) % (X - A)) >= 0 && n * ((C - B) % (X - B)) >= 0 && n * ((A - C) % (X - C)) >= 0) ray.Hit(t, this);
            """)),
        new("triangle", "t = e1·q / det", MollerTrumbore(t: "e1 * q / det")),
        new("triangle", "u − v ≤ 1", MollerTrumbore(last: "u - v <= 1")),
        new("triangle", "u = s·p, not divided", MollerTrumbore(u: "s * p")),
        new("rule", "z = t² (−d·W)", new Edit("Ray", "t * DepthPerT;", "t * t * DepthPerT;")),
        new("rule", "z ≤ zFar / 2", new Edit("Ray", "z <= ZFar", "z <= ZFar / 2")),
        new("rule", "z ≥ zFar for z ≥ zNear", new Edit("Ray", "ZNear <= z", "ZFar <= z")),
        new("light", "1 − t / |T − P|²", new Edit("Camera", "(2 * (Target - Position)).Length", "((Target - Position) * (Target - Position))")),
        new("light", "1 − t / 2 |T|", new Edit("Camera", "2 * (Target - Position)", "2 * Target")),
        new("light", "1 − t / 2 |P|", new Edit("Camera", "2 * (Target - Position)", "2 * Position")),
        new("light", "1 − √t / 2 |T − P|", new Edit("Camera", "1 - ray.HitParameter", "1 - Math.Sqrt(ray.HitParameter)")),
        new("light", "1 − (t / 2 |T − P|)²", new Edit("Camera", "1 - ray.HitParameter / (2 * (Target - Position)).Length",
            "1 - Math.Pow(ray.HitParameter / (2 * (Target - Position)).Length, 2)")),
        new("light", "not below ½", new Edit("Camera", "Math.Max(0, attenuation)", "Math.Max(0.5, attenuation)")),
        new("light", "1 − 2 t / |T − P|", new Edit("Camera", "ray.HitParameter / (2 * (Target", "2 * ray.HitParameter / ((Target")),
        new("bytes", "128 colour", new Edit("Color", "* 255 + 0.5", "* 128 + 0.5")),
        new("bytes", "√colour", new Edit("Color", "Clamp(channel, 0", "Clamp(Math.Sqrt(channel), 0")),
        new("bytes", "clamped at ½", new Edit("Color", "Clamp(channel, 0, 1)", "Clamp(channel, 0, 0.5)")),
    ];

    public Picture Draw() =>
        EditedLab.Render(scene, Manner.OfTheSlides, slip < 0 ? Planted.None : new(All[slip].What, "", All[slip].Edits), otherFormulas);

    private static Edit[] Pythagoras(string ofL) =>
        [new("Sphere", "D * D > R", $"L * L - {ofL} > R"), new("Sphere", "(R * R - D * D)", $"(R * R - (L * L - {ofL}))")];

    private static Edit MollerTrumbore(
        string e2 = "C - A", string u = "s * p / det", string t = "e2 * q / det", string last = "u + v <= 1") => Instead($$"""
            var (e1, e2, s, d) = (B - A, {{e2}}, ray.Origin - A, ray.Direction);
            var (p, q) = (d % e2, s % e1);
            var det = e1 * p;
            var (u, v, t) = ({{u}}, d * q / det, {{t}});
            if (u >= 0 && v >= 0 && {{last}}) ray.Hit(t, this);
            """);

    /// <summary>Another body for the triangle's method.</summary>
    private static Edit Instead(string body) =>
        new("Triangle", "public override void Intersect(Ray ray)",
            $"public sealed override void Intersect(Ray ray) {{ {body} }} void OfTheLab(Ray ray)");

    /// <summary>An edit of a shape that reads the camera's target, which the lab's shapes do not know.</summary>
    private static Edit[] FromTarget(string file, string old, string @new) =>
    [
        new("Camera", "public Vector3 Position,", "public static Vector3 T; public Vector3 Position,"),
        new("Camera", "h = 2 *", "T = target; h = 2 *"),
        new(file, old, @new),
    ];
}
