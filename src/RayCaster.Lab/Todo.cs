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

    private static readonly Lazy<((int Step, string Slide, string What)[] Missing, string Endless)> found = new(Find);

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
    public static (int Step, string Slide, string What)[] Missing() => found.Value.Missing;

    /// <summary>The same in one line, and a call that does not end; empty if all is written and ends.</summary>
    public static string Report()
    {
        var (missing, endless) = found.Value;
        var loop = endless == null ? "" : $"{endless} does not end: is there an endless loop in it?";
        if (missing is not [var next, ..]) return loop;
        var todo = $"Not written yet: {string.Join(", ", missing.Select(body => body.What))}. Next: step {next.Step}, slide \"{next.Slide}\"";
        return loop == "" ? todo : $"{loop}\n{todo}";
    }

    /// <summary>Calls every body once, in the order in which they are to be written, up to one that does not end.</summary>
    private static ((int Step, string Slide, string What)[], string) Find()
    {
        var set = notes = [];
        var (v, ray) = (new Vector3(1, 2, 3), new Ray(Vector3.Zero, new(1, 0, 0)) { HitModel = new Plane(Vector3.Zero, new(1, 0, 0)) });
        Camera camera = null;
        (string Name, Action Call)[] calls =
        [
            ("a + b", () => _ = v + v), ("a - b", () => _ = v - v), ("b * a", () => _ = 2 * v), ("a * b", () => _ = v * v),
            ("a % b", () => _ = v % v), ("Length", () => _ = v.Length),
            ("At", () => ray.At(1)), ("Counts", () => ray.Counts(1)), ("Hit", () => new Ray(v, v).Hit(1, null)),
            ("Plane.Intersect", () => new Plane(v, v).Intersect(ray)),
            ("Camera", () => camera = new(v, Vector3.Zero, new(0, 0, 1), 45, 1, 1)), ("Direction", () => camera.Direction(0, 0)),
            ("CastRay", () => new Scene(camera, new(0, 0, 0)).CastRay(0, 0)), ("Shade", () => camera.Shade(ray)),
            ("Slab", () => Aabb.Slab(0, 1, 0, 1)), ("Aabb.Intersect", () => new Aabb(v, v).Intersect(ray)),
            ("GeometricSolution", () => new Sphere(v, 1).GeometricSolution(ray)),
            ("AnalyticalSolution", () => new Sphere(v, 1).AnalyticalSolution(ray)),
            ("Circle.Intersect", () => new Circle(v, v, 1).Intersect(ray)), ("Triangle.Intersect", () => new Triangle(v, v, v).Intersect(ray)),
        ];
        var endless = calls.FirstOrDefault(call => !Ends(call.Call)).Name;
        notes = null;
        lock (set) return ([.. Bodies.Where(body => set.Contains(body.Slide))], endless);
    }

    /// <summary>Whether a call ends within some seconds. One that does not runs on in the background until the program ends.</summary>
    private static bool Ends(Action call)
    {
        var thread = new Thread(Try) { IsBackground = true };
        thread.Start();
        return thread.Join(TimeSpan.FromSeconds(5));

        void Try()
        {
            try { call(); } catch (Exception) { } // the tests tell about that
        }
    }
}
