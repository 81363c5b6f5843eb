namespace RayCaster.Teaching;

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Formula">Its formula, as a mistake's concern.</param>
internal sealed record ShapeKind(string Name, string One, string Many, Concerns Formula)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", Concerns.Planes),
        new("sphere", "sphere", "spheres", Concerns.Spheres),
        new("aabb", "box", "boxes", Concerns.Boxes),
        new("circle", "circle", "circles", Concerns.Circles),
        new("triangle", "triangle", "triangles", Concerns.Triangles),
        new("mesh", "mesh", "meshes", Concerns.Triangles),
    ];

    /// <summary>The slide with its formula.</summary>
    public string Slide => Slides.OfShape(Name)!;

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Formula);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Of(string name) => Array.Find(All, kind => kind.Name == name);
}
