namespace RayCaster.Teaching;

/// <summary>A step of the lab: the slides whose code students write in it.</summary>
/// <param name="Name">Its name in CI.</param>
/// <param name="Question">What to ask oneself where no single mistake can be named; null for none.</param>
public sealed record LabStep(string Name, string? Question, params string[] Slides);

/// <summary>The titles of the slides, as the slides have them, and the steps of the lab; docs/slides-to-code.md lists them all.</summary>
public static class Slides
{
    internal const string Vectors = "IDE & Vectors";
    internal const string Ray = "Ray";
    internal const string RayCasting = "Ray Casting";
    internal const string Template = "Template";
    internal const string RayPlane = "Ray – Plane Intersection";
    internal const string Camera = "Camera";
    internal const string PixelTranslation = "Camera Pixel Translation";
    internal const string Shading = "Primitive Shading";
    internal const string ClipPlanes = "zNear & zFar";
    internal const string Bias = "Bias";
    internal const string Box = "AABB (Axis Aligned Bounding Box)";
    internal const string BoxParameters = "AABB – intersection parameters";
    internal const string BoxTest = "AABB checking for intersection";
    internal const string Sphere = "Sphere – Geometric Solution";
    internal const string SphereAnalytical = "Sphere – Analytical Solution";
    internal const string Circle = "Circle";
    internal const string Triangle = "Triangle";

    /// <summary>The steps in which students write the lab; the first is step 1.</summary>
    public static readonly IReadOnlyList<LabStep> Steps =
    [
        new("vectors", null, Vectors),
        new("ray", null, Ray),
        new("plane", null, RayPlane),
        new("camera", "Take the ray of one pixel: what are d, the nearest t and the model that is hit there?",
            Camera, PixelTranslation, RayCasting),
        new("shading", "What is 1 − t / (2 |T − P|) at t = 0, and at the target? Does your program compute that?", Shading),
        new("zNear, zFar, bias", "Take a hit that should show: which is false of t > bias, zNear ≤ z and z ≤ zFar?", ClipPlanes, Bias),
        new("box", "Take a ray to a face that is wrong: what are t0 and t1 of each slab, t_min and t_max? What if d is negative?",
            BoxParameters, BoxTest, Box),
        new("sphere", "Take a ray through the centre: what are t_ca, D and t_hc? What if the camera is inside?", Sphere, SphereAnalytical),
        new("circle", "Take a ray through C: what is t, and how long is X − C?", Circle),
        new("triangle", "Take a ray through the middle of a triangle: what are t, u and v?", Triangle),
    ];

    /// <summary>The step, from 1, in which students write the code of a slide; 0 for a slide without code.</summary>
    public static int StepOf(string slide) =>
        Enumerable.Range(1, Steps.Count).FirstOrDefault(step => Steps[step - 1].Slides.Contains(slide));
}
