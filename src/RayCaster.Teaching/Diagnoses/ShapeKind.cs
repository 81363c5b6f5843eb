namespace RayCaster.Teaching;

/// <summary>A kind of shape on the slides.</summary>
/// <param name="Name">What scene files call it.</param>
/// <param name="Formula">Its formula, as a mistake's concern.</param>
/// <param name="Step">The step of the lab in which it is written.</param>
internal sealed record ShapeKind(string Name, string One, string Many, Concerns Formula, string Slide, int Step)
{
    public static readonly ShapeKind[] All =
    [
        new("plane", "plane", "planes", Concerns.Planes, Slides.RayPlane, 3),
        new("sphere", "sphere", "spheres", Concerns.Spheres, Slides.Sphere, 8),
        new("aabb", "box", "boxes", Concerns.Boxes, Slides.Box, 7),
        new("circle", "circle", "circles", Concerns.Circles, Slides.Circle, 9),
        new("triangle", "triangle", "triangles", Concerns.Triangles, Slides.Triangle, 10),
        new("mesh", "mesh", "meshes", Concerns.Triangles, Slides.Triangle, 10),
    ];

    /// <summary>Those with a formula of their own: a mesh has its triangles'.</summary>
    public static IEnumerable<ShapeKind> Basic => All.DistinctBy(kind => kind.Formula);

    /// <summary>The kind of a name; null for a shape of one's own.</summary>
    public static ShapeKind? Of(string name) => Array.Find(All, kind => kind.Name == name);
}
