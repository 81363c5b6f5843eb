namespace RayCaster.Teaching;

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Formula">Its formula, among all that mistakes affect.</param>
internal sealed record ShapeKind(string Name, string One, string Many, Affects Formula)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", Affects.Planes),
        new("sphere", "sphere", "spheres", Affects.Spheres),
        new("aabb", "box", "boxes", Affects.Boxes),
        new("circle", "circle", "circles", Affects.Circles),
        new("triangle", "triangle", "triangles", Affects.Triangles),
        new("mesh", "mesh", "meshes", Affects.Triangles),
    ];

    /// <summary>The slide with its formula.</summary>
    public string Slide => Slides.OfShape(Name)!;

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Formula);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Of(string name) => Array.Find(All, kind => kind.Name == name);
}
