namespace Lab;

/// <summary>Knows what is not written yet: each body that is to be written begins with a note, which goes when the body is written.</summary>
public static class Todo
{
    /// <summary>All bodies, in the order in which they are to be written.</summary>
    public static readonly (int Step, string Slide, string What)[] Bodies =
    [
        (1, "IDE & Vectors", "vectors"),
        (2, "Ray", "ray"),
        (3, "Ray – Plane Intersection", "plane"),
        (4, "Camera", "camera"), (4, "Camera Pixel Translation", "ray through a pixel"), (4, "Ray Casting", "ray casting"),
        (5, "Primitive Shading", "attenuation"),
        (6, "zNear & zFar", "zNear and zFar"), (6, "Bias", "bias"),
        (7, "AABB – intersection parameters", "slab"), (7, "AABB checking for intersection", "box"),
        (8, "Sphere – Geometric Solution", "sphere"), (8, "Sphere – Analytical Solution", "analytical sphere"),
        (9, "Circle", "circle"),
        (10, "Triangle", "triangle"),
    ];

    private static HashSet<string> notes; // only while Missing listens

    /// <summary>Notes that the body where this stands is not written.</summary>
    public static void Note(string slide)
    {
        if (notes is { } set) lock (set) set.Add(slide);
    }

    public static T Note<T>(string slide, T value) // where a value is needed for the time being
    {
        Note(slide);
        return value;
    }

    /// <summary>What is not written yet. Calls everything once to find out.</summary>
    public static (int Step, string Slide, string What)[] Missing()
    {
        var set = notes = [];
        var (v, ray) = (new Vector3(1, 2, 3), new Ray(Vector3.Zero, new(1, 0, 0)) { HitModel = new Plane(Vector3.Zero, new(1, 0, 0)) });
        Camera camera = null;
        Action[] calls =
        [
            () => camera = new(v, Vector3.Zero, new(0, 0, 1), 45, 1, 1), () => camera.Direction(0, 0), () => camera.Shade(ray),
            () => new Scene(camera, new(0, 0, 0)).CastRay(0, 0),
            () => _ = v + v, () => _ = v - v, () => _ = 2 * v, () => _ = v * v, () => _ = v % v, () => _ = v.Length,
            () => ray.Hit(1, null), () => ray.At(1), () => ray.Counts(1), () => new Plane(v, v).Intersect(ray),
            () => new Aabb(v, v).Intersect(ray), () => Aabb.Slab(0, 1, 0, 1),
            () => new Sphere(v, 1).GeometricSolution(ray), () => new Sphere(v, 1).AnalyticalSolution(ray),
            () => new Circle(v, v, 1).Intersect(ray), () => new Triangle(v, v, v).Intersect(ray),
        ];
        foreach (var call in calls)
            try { call(); } catch (Exception) { } // the tests tell about that
        notes = null;
        return [.. Bodies.Where(body => set.Contains(body.Slide))];
    }

    /// <summary>The same in one line; empty if all is written.</summary>
    public static string Report() => Missing() is not [var next, ..] missing ? ""
        : $"Not written yet: {string.Join(", ", missing.Select(body => body.What))}. Next: step {next.Step}, slide \"{next.Slide}\"";
}
