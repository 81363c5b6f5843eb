using System.Runtime.CompilerServices;

namespace Lab;

/// <summary>
/// Knows what is not written yet. In the hand-out each method that you write begins with a call of Todo.Note: delete that line when you have
/// written the method. You need not read this.
/// </summary>
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

    private static readonly Dictionary<string, string> notes = []; // where the note of a slide stands

    private static bool listens; // only while bodies are called once: a picture would make a note for each pixel

    /// <summary>Notes that the body where this stands is not written.</summary>
    public static void Note(string slide, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
    {
        if (Volatile.Read(ref listens)) lock (notes) notes.TryAdd(slide, $"src/Lab/{Path.GetFileName(file)}, line {line}");
    }

    // Where a value is needed for the time being.
    public static T Note<T>(string slide, T value, [CallerFilePath] string file = "", [CallerLineNumber] int line = 0)
    {
        Note(slide, file, line);
        return value;
    }

    /// <summary>From now on, each body that is called and not written makes its note.</summary>
    public static void Listen() => Volatile.Write(ref listens, true);

    /// <summary>The slides of the notes so far: their bodies are not written.</summary>
    public static string[] NotWritten { get { lock (notes) return [.. notes.Keys]; } }

    /// <summary>What is not written yet of the first steps.</summary>
    public static (int Step, string Slide, string What)[] Missing(int steps = 10)
    {
        lock (Bodies)
            try { listens = true; BodyCalls.OfFirstSteps(steps); }
            finally { listens = false; }
        lock (notes) return [.. Bodies.Where(body => body.Step <= steps && notes.ContainsKey(body.Slide))];
    }

    /// <summary>The same in a line; empty if all is written.</summary>
    public static string Report(int steps = 10) => Missing(steps) is not [var next, ..] missing ? ""
        : $"Not written yet: {string.Join(", ", missing.Select(body => body.What))}. Next: step {next.Step}, slide \"{next.Slide}\"\n" +
            $"  Is it written? Todo.Note(\"{next.Slide}\") is still in {notes[next.Slide]}: delete that line.";
}
