namespace Lab;

/// <summary>Calls the bodies that are to be written, so that those that are not written yet call <see cref="Todo.Note(string)"/>.</summary>
public static class BodyCalls
{
    private static readonly Vector3 v = new(1, 2, 3);

    private static readonly Ray ray = new(new(0, 0, 0), new(1, 0, 0)) { HitModel = new Plane(new(0, 0, 0), new(1, 0, 0)) };

    private static Camera camera;

    private static readonly (int Step, string Name, Action Call)[] calls = // in the order in which the bodies are to be written
    [
        (1, "a + b", () => _ = v + v), (1, "a - b", () => _ = v - v), (1, "b * a", () => _ = 2 * v), (1, "a * b", () => _ = v * v),
        (1, "a % b", () => _ = v % v), (1, "Length", () => _ = v.Length),
        (2, "At", () => ray.At(1)), (2, "Counts", () => ray.Counts(1)), (2, "Hit", () => new Ray(v, v).Hit(1, null)),
        (3, "Plane.Intersect", () => new Plane(v, v).Intersect(ray)),
        (4, "Camera", () => camera = new(v, Vector3.Zero, new(0, 0, 1), 45, 1, 1)), (4, "Direction", () => camera.Direction(0, 0)),
        (4, "CastRay", () => new Scene(camera, new(0, 0, 0)).CastRay(0, 0)), (5, "Shade", () => camera.Shade(ray)),
        (7, "Slab", () => Aabb.Slab(0, 1, 0, 1)), (7, "Aabb.Intersect", () => new Aabb(v, v).Intersect(ray)),
        (8, "GeometricSolution", () => new Sphere(v, 1).GeometricSolution(ray)),
        (8, "AnalyticalSolution", () => new Sphere(v, 1).AnalyticalSolution(ray)),
        (9, "Circle.Intersect", () => new Circle(v, v, 1).Intersect(ray)),
        (10, "Triangle.Intersect", () => new Triangle(v, v, v).Intersect(ray)),
    ];

    private static int called;

    private static (int Step, string Name)? endless; // the first that does not end

    /// <summary>Calls those of the first steps, each once in the program's life.</summary>
    /// <returns>Says which is the first that does not end; null if all end.</returns>
    public static string FirstThatDoesNotEnd(int steps)
    {
        for (; called < calls.Length && calls[called].Step <= steps; called++)
        {
            var (step, name, call) = calls[called];
            // After the first, the others that call it do not end either: these get less time.
            if (!Ends(call, TimeSpan.FromSeconds(endless == null ? 5 : 0.2))) endless ??= (step, name);
        }
        return endless is var (first, which) && first <= steps ? $"{which} does not end: is there an endless loop in it?" : null;
    }

    /// <summary>Whether a call ends in time. One that does not runs on in the background until the program ends.</summary>
    private static bool Ends(Action call, TimeSpan time)
    {
        var thread = new Thread(Try) { IsBackground = true };
        thread.Start();
        return thread.Join(time);

        void Try()
        {
            try { call(); } catch (Exception) { } // the tests report that
        }
    }
}
