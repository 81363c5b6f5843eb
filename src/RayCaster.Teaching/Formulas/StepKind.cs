namespace RayCaster.Teaching.Formulas;

/// <summary>What a step's formulas are for, in pipeline order. A scene needs one of both samples, and one of both rules of a crossing.</summary>
internal enum StepKind
{
    Vectors,
    Camera,
    File,
    Corner,
    Center,
    Pixel,
    Plane,
    Circle,
    Sphere,
    Aabb,
    Triangle,
    Depth,
    Distance,
    Nearest,
    Light,
    Bytes,
}

internal static class StepKinds
{
    /// <summary>Whether a step is on the way from a pixel to its ray.</summary>
    public static bool IsOfRays(this StepKind step) =>
        step is StepKind.Vectors or StepKind.Camera or StepKind.Pixel || step.IsOfSample();

    /// <summary>Whether a step is the formula of a kind of shape.</summary>
    public static bool IsOfShape(this StepKind step) => step is >= StepKind.Plane and <= StepKind.Triangle;

    /// <summary>Whether a step decides which crossing counts, and which of two hits shows.</summary>
    public static bool IsOfHits(this StepKind step) => step is StepKind.Depth or StepKind.Distance or StepKind.Nearest;

    /// <summary>Whether a step says which point of its pixel a ray passes.</summary>
    public static bool IsOfSample(this StepKind step) => step is StepKind.Corner or StepKind.Center;

    /// <summary>Whether a step is on the way from a hit to three bytes.</summary>
    public static bool IsOfColors(this StepKind step) => step is StepKind.Light or StepKind.Bytes;

    /// <summary>The step by which a scene's pixels are sampled.</summary>
    public static StepKind SampleOf(Camera camera) => camera.Sample == PixelSample.Corner ? StepKind.Corner : StepKind.Center;

    /// <summary>The step by which a scene's crossings count.</summary>
    public static StepKind RuleOf(Camera camera) => camera.Clip == ClipMode.Depth ? StepKind.Depth : StepKind.Distance;

    /// <summary>What texts call it: both samples, and both rules, have one name.</summary>
    public static string InWords(this StepKind step) =>
        step.IsOfSample() ? "sample" : step is StepKind.Depth or StepKind.Distance ? "rule" : step.ToString().ToLowerInvariant();
}

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Step">The step with its formula.</param>
/// <param name="Slide">The title of the slide with its formula.</param>
/// <param name="NumbersOf">A model's numbers, in the order of "given" in Shapes.txt; null for a model of another class, and for meshes.</param>
internal sealed record ShapeKind(string Name, string One, string Many, StepKind Step, string Slide, Func<Model, PixelValues[]?> NumbersOf)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", StepKind.Plane, Slides.RayPlane,
            Numbers<Plane>(p => [PixelValues.From(p.Point), PixelValues.From(p.Normal)])),
        new("sphere", "sphere", "spheres", StepKind.Sphere, Slides.Sphere,
            Numbers<Sphere>(s => [PixelValues.From(s.Center), PixelValues.From(s.Radius)])),
        new("aabb", "box", "boxes", StepKind.Aabb, Slides.Box, Numbers<Aabb>(b => [PixelValues.From(b.Min), PixelValues.From(b.Max)])),
        new("circle", "circle", "circles", StepKind.Circle, Slides.Circle,
            Numbers<Circle>(c => [PixelValues.From(c.Center), PixelValues.From(c.Normal), PixelValues.From(c.Radius)])),
        new("triangle", "triangle", "triangles", StepKind.Triangle, Slides.Triangle,
            Numbers<Triangle>(t => [PixelValues.From(t.A), PixelValues.From(t.B), PixelValues.From(t.C)])),
        new("mesh", "mesh", "meshes", StepKind.Triangle, Slides.Triangle, _ => null),
    ];

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Step);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Find(string name) => Array.Find(All, kind => kind.Name == name);

    /// <summary>The kind whose formula a step has.</summary>
    public static ShapeKind Find(StepKind step) => All.First(kind => kind.Step == step);

    private static Func<Model, PixelValues[]?> Numbers<P>(Func<P, PixelValues[]> numbers) where P : struct, IPrimitive =>
        model => model is Model<P> { Primitive: var shape } ? numbers(shape) : null;
}
