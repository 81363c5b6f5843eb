namespace Lab;

/// <summary>What --pixel asks your methods for. You need not read this.</summary>
public static class Pixel
{
    /// <summary>The calls of your methods for a pixel, by the names of their results.</summary>
    public static IEnumerable<(string, Func<object>)> Calls(RayCaster.Scene from, int c, int r)
    {
        Scene scene = null;
        Ray ray = null;
        return
        [
            .. CallsOf("a + b", (a, b) => Of(a + b)), .. CallsOf("a − b", (a, b) => Of(a - b)), .. CallsOf("2 a", (a, _) => Of(2 * a)),
            .. CallsOf("a × b", (a, b) => Of(a % b)), .. CallsOf("a · b", (a, b) => a * b), .. CallsOf("|a|", (a, _) => a.Length),
            ("W", () => Of((scene = SceneFile.Of(from)).Camera.W)),
            ("U", () => Of(scene.Camera.U)), ("V", () => Of(scene.Camera.V)),
            ("h", () => scene.Camera.h), ("w", () => scene.Camera.w),
            ("d", () => Of((ray = scene.Camera.RayThrough(c, r)).Direction)),
            .. from.Models.SelectMany((model, i) => CallsOf($"{i}", model, () => ray)),
            ("hit", () =>
            {
                var hit = -1;
                for (var i = 0; i < from.Models.Count; i++)
                    foreach (var part in SceneFile.PartsOf(from.Models[i]))
                    {
                        part.Intersect(ray);
                        if (ray.HitModel == part) hit = i;
                    }
                return (hit, ray.HitParameter);
            }),
            ("attenuation", () => scene.Camera.Shade(new(ray.Origin, ray.Direction)
                { HitParameter = ray.HitParameter, HitModel = new Plane(Vector3.Zero, Vector3.Zero) }).R), // which is white
            ("bytes", () => scene.CastRay(c, r).ToBytes()),
        ];
    }

    private static object Of(Vector3 v) => (v.X, v.Y, v.Z);

    /// <summary>What an operator makes of two vectors, and what these are afterwards.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, Func<Vector3, Vector3, object> compute)
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6); // new ones for each operator, in case that it changes them
        return [(name, () => compute(a, b)), ($"a after {name}", () => Of(a)), ($"b after {name}", () => Of(b))];
    }

    /// <summary>Each t with which a model calls Hit, and whether it counts; of a sphere by both solutions.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, RayCaster.Model model, Func<Ray> ray)
    {
        yield return (name, () => HitsOf(model, ray(), part => part.Intersect));
        if (model is RayCaster.Model<RayCaster.Sphere>)
            yield return ($"{name} analytical", () => HitsOf(model, ray(), part => ((Sphere)part).AnalyticalSolution));
    }

    private static (double, bool)[] HitsOf(RayCaster.Model model, Ray ray, Func<Model, Action<Ray>> intersect)
    {
        var watched = new WatchedRay(ray);
        foreach (var part in SceneFile.PartsOf(model)) intersect(part)(watched);
        return [.. watched.Hits];
    }

    private sealed class WatchedRay : Ray
    {
        public readonly List<(double, bool)> Hits = [];

        public WatchedRay(Ray ray) : base(ray.Origin, ray.Direction) =>
            (Bias, ZNear, ZFar, DepthPerT) = (ray.Bias, ray.ZNear, ray.ZFar, ray.DepthPerT);

        public override void Hit(double t, Model model) => Hits.Add((t, Counts(t)));
    }
}
