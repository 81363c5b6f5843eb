namespace RayCaster.Teaching.Formulas;

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Step">The step with its formula.</param>
/// <param name="Slide">The title of the slide with its formula.</param>
internal sealed record ShapeKind(string Name, string One, string Many, StepKind Step, string Slide)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", StepKind.Plane, Slides.RayPlane),
        new("sphere", "sphere", "spheres", StepKind.Sphere, Slides.Sphere),
        new("aabb", "box", "boxes", StepKind.Aabb, Slides.Box),
        new("circle", "circle", "circles", StepKind.Circle, Slides.Circle),
        new("triangle", "triangle", "triangles", StepKind.Triangle, Slides.Triangle),
        new("mesh", "mesh", "meshes", StepKind.Triangle, Slides.Triangle),
    ];

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Step);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Of(string name) => Array.Find(All, kind => kind.Name == name);

    /// <summary>The kind whose formula a step has.</summary>
    public static ShapeKind Of(StepKind step) => All.First(kind => kind.Step == step);
}
