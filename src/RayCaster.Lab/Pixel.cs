using RayCaster.Teaching;

namespace Lab;

/// <summary>What --pixel asks your bodies for. You need not read this.</summary>
public static class Pixel
{
    /// <summary>Prints what the bodies compute for a pixel, beside the right numbers; returns the program's exit code.</summary>
    /// <param name="pixel">What follows --pixel.</param>
    public static int Print(RayCaster.Scene from, string[] pixel)
    {
        Todo.Listen();
        return PixelNumbers.Print(from, pixel, (c, r) => Calls(from, c, r), () => Todo.NotWritten);
    }

    /// <summary>The calls of the bodies for a pixel, by the names of their results.</summary>
    public static IEnumerable<(string, Func<object>)> Calls(RayCaster.Scene from, int c, int r)
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        Scene scene = null;
        Ray ray = null;
        return
        [
            ("a + b", () => Of(a + b)), ("a − b", () => Of(a - b)), ("2 a", () => Of(2 * a)), ("a × b", () => Of(a % b)),
            ("a · b", () => a * b), ("|a|", () => a.Length),
            ("W", () => Of((scene = SceneFile.Of(from)).Camera.W)),
            ("U", () => Of(scene.Camera.U)), ("V", () => Of(scene.Camera.V)),
            ("h", () => scene.Camera.h), ("w", () => scene.Camera.w),
            ("d", () => Of((ray = scene.Camera.RayThrough(c, r)).Direction)),
            .. from.Models.Select((model, i) => ($"{i}", (Func<object>)(() => HitsOf(model, ray)))),
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

    /// <summary>Each t with which a model calls Hit, and whether it counts.</summary>
    private static (double, bool)[] HitsOf(RayCaster.Model model, Ray ray)
    {
        var watched = new WatchedRay(ray);
        foreach (var part in SceneFile.PartsOf(model)) part.Intersect(watched);
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
