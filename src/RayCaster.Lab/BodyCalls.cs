namespace Lab;

/// <summary>Calls each body that is to be written, so that those that are not written yet call <see cref="Todo.Note(string)"/>.</summary>
public static class BodyCalls
{
    /// <summary>Calls all in the order in which they are to be written.</summary>
    /// <returns>The name of the first that does not end; null if all end.</returns>
    public static string FirstThatDoesNotEnd()
    {
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
        string first = null;
        foreach (var (name, call) in calls) // after the first, the others that call it do not end either: these get less time
            if (!Ends(call, TimeSpan.FromSeconds(first == null ? 5 : 0.2))) first ??= name;
        return first;
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
