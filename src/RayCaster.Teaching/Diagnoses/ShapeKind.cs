namespace RayCaster.Teaching;

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Step">The step with its formula.</param>
internal sealed record ShapeKind(string Name, string One, string Many, SectionKind Step)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", SectionKind.Plane),
        new("sphere", "sphere", "spheres", SectionKind.Sphere),
        new("aabb", "box", "boxes", SectionKind.Aabb),
        new("circle", "circle", "circles", SectionKind.Circle),
        new("triangle", "triangle", "triangles", SectionKind.Triangle),
        new("mesh", "mesh", "meshes", SectionKind.Triangle),
    ];

    /// <summary>The slide with its formula.</summary>
    public string Slide => Slides.OfShape(Name)!;

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Step);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Of(string name) => Array.Find(All, kind => kind.Name == name);

    /// <summary>The kind whose formula a step has.</summary>
    public static ShapeKind Of(SectionKind step) => All.First(kind => kind.Step == step);
}
