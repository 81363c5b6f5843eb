namespace Lab;

/// <summary>Knows what is not written yet: each body that is to be written begins with a note, which is deleted when the body is written.</summary>
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

    private static readonly Lazy<(HashSet<string> Notes, (int Step, string Message)? Endless)> found = new(Find);
    private static HashSet<string> notes; // only while Find listens

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

    /// <summary>What is not written yet.</summary>
    public static (int Step, string Slide, string What)[] Missing()
    {
        lock (found.Value.Notes) return [.. Bodies.Where(body => found.Value.Notes.Contains(body.Slide))];
    }

    /// <summary>The first body that does not end.</summary>
    public static (int Step, string Message)? Endless => found.Value.Endless;

    /// <summary>Both in a line each; empty if all is written and ends.</summary>
    public static string Report()
    {
        var todo = Missing() is not [var next, ..] missing ? null
            : $"Not written yet: {string.Join(", ", missing.Select(body => body.What))}. Next: step {next.Step}, slide \"{next.Slide}\"";
        return string.Join("\n", new[] { Endless?.Message, todo }.Where(line => line != null));
    }

    private static (HashSet<string>, (int, string)?) Find()
    {
        var set = notes = [];
        var endless = BodyCalls.FirstThatDoesNotEnd();
        notes = null;
        return (set, endless);
    }
}
