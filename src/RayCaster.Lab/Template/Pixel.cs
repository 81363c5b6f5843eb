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
            .. ExamplesOfRay(), .. ExamplesOfSlab(),
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
                        part.Color = new(from.Models[i].Color.R, from.Models[i].Color.G, from.Models[i].Color.B);
                        part.Intersect(ray);
                        if (ray.HitModel == part) hit = i;
                    }
                return (hit, ray.HitParameter);
            }),
            ("attenuation", () => Shaded(new Plane(Vector3.Zero, Vector3.Zero)).R), // which is white
            ("Shade", () => Shaded(ray.HitModel) is var color ? (color.R, color.G, color.B) : null),
            ("bytes", () => scene.CastRay(c, r).ToBytes()),
        ];

        Color Shaded(Model model) => scene.Camera.Shade(new(ray.Origin, ray.Direction)
        {
            HitParameter = ray.HitParameter, HitModel = model, Bias = ray.Bias, ZNear = ray.ZNear, ZFar = ray.ZFar, DepthPerT = ray.DepthPerT,
        });
    }

    /// <summary>For a ray that no camera makes: X(t), which of the conditions of Counts holds, which hit stays, and a plane.</summary>
    private static IEnumerable<(string, Func<object>)> ExamplesOfRay()
    {
        Ray Fresh() => new(new(1, 2, 3), new(0.48, 0.6, -0.64));
        yield return ("X(5)", () => Of(Fresh().At(5)));
        foreach (var (t, bias) in ((double, double)[])[(1, 2), (2, 2), (3, 2), (-1, 0), (0, 0)]) // wherever zNear and zFar are
            yield return ($"isAhead of Counts({(t < 0 ? "−1" : t)}) for Bias = {bias}", () => ((double, double)[])[(-1e9, 1e9), (1e9, -1e9), (t, t)] is var ranges &&
                ranges.Any(z => new Ray(Vector3.Zero, Vector3.Zero) { Bias = bias, ZNear = z.Item1, ZFar = z.Item2 }.Counts(t)));
        foreach (var t in (double[])[4, 16, 10, 6, 14]) // whatever the bias is
            yield return ($"isBetween of Counts({t}) for ZNear = 3, ZFar = 7, DepthPerT = 0.5", () => ((double[])[-1e9, 1e9, 0]).Any(bias =>
                new Ray(Vector3.Zero, Vector3.Zero) { Bias = bias, ZNear = 3, ZFar = 7, DepthPerT = 0.5 }.Counts(t)));
        foreach (var (name, calls) in ((string, double[])[])[("Hit(5), Hit(3), Hit(4)", [5, 3, 4]), ("Hit(3), Hit(3)", [3, 3]),
            ("Hit(−3), Hit(NaN)", [-3, double.NaN])])
        {
            var hit = Fresh();
            yield return ($"HitParameter after {name}", () =>
            {
                foreach (var (i, t) in calls.Index()) hit.Hit(t, new Sphere(Vector3.Zero, i));
                return hit.HitParameter;
            });
            yield return ($"HitModel after {name}", () => hit.HitModel is not Sphere { R: var i } ? "null"
                : calls[0] == calls[1] ? $"that of the {(i == 0 ? "first" : "second")} Hit({calls[(int)i]})" : $"that of Hit({calls[(int)i]})");
        }
        yield return ("plane", () => HitsOf(new Plane(new(3, 3, -1), new(1, 2, -1)), Fresh()));
    }

    /// <summary>A slab from each side, from inside, and parallel to it: inside, outside, and on each face.</summary>
    private static IEnumerable<(string, Func<object>)> ExamplesOfSlab() =>
        from slab in ((double, double)[])[(0, 0.5), (5, -1), (2, 0.5), (2, 0), (0, 0), (4, 0), (1, 0), (3, 0)]
        select (FormattableString.Invariant($"Slab(1, 3, {slab.Item1}, {slab.Item2})"), (Func<object>)(() => Aabb.Slab(1, 3, slab.Item1, slab.Item2)));

    private static object Of(Vector3 v) => (v.X, v.Y, v.Z);

    /// <summary>What an operator makes of two vectors, and what these are afterwards.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, Func<Vector3, Vector3, object> compute)
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6); // new ones for each operator, in case that it changes them
        return [(name, () => compute(a, b)), ($"a after {name}", () => Of(a)), ($"b after {name}", () => Of(b))];
    }

    /// <summary>Each t with which a model calls Hit, and whether it counts; of a sphere by both solutions, of a box also its slabs' numbers.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, RayCaster.Model model, Func<Ray> ray)
    {
        yield return (name, () => HitsOf(model, ray(), part => part.Intersect));
        if (model is RayCaster.Model<RayCaster.Sphere>)
            yield return ($"{name} analytical", () => HitsOf(model, ray(), part => ((Sphere)part).AnalyticalSolution));
        if (model is RayCaster.Model<RayCaster.Aabb>)
            yield return ($"{name} slabs", () => SlabsOf((Aabb)SceneFile.PartsOf(model).Single(), ray()));
    }

    /// <summary>Of each axis, what Slab returns; then the same as Intersect has it, with which it calls Hit if the box is endless along the others.
    /// </summary>
    private static double[] SlabsOf(Aabb box, Ray ray)
    {
        const double far = 1e9;
        var (B0, B1, P, d) = (box.B0, box.B1, ray.Origin, ray.Direction);
        (double, double)[] bySlab = [Aabb.Slab(B0.X, B1.X, P.X, d.X), Aabb.Slab(B0.Y, B1.Y, P.Y, d.Y), Aabb.Slab(B0.Z, B1.Z, P.Z, d.Z)];
        var byIntersect = from endless in (Aabb[])[new(new(B0.X, -far, -far), new(B1.X, far, far)), new(new(-far, B0.Y, -far), new(far, B1.Y, far)),
                new(new(-far, -far, B0.Z), new(far, far, B1.Z))]
            select HitsOf(endless, ray) is [var (first, _), var (second, _)] ? (first, second) : (double.NaN, double.NaN);
        return [.. bySlab.Concat(byIntersect).SelectMany(pair => (double[])[pair.Item1, pair.Item2])];
    }

    private static (double, bool)[] HitsOf(RayCaster.Model model, Ray ray, Func<Model, Action<Ray>> intersect) =>
        [.. SceneFile.PartsOf(model).SelectMany(part => HitsOf(part, ray, intersect))];

    private static (double, bool)[] HitsOf(Model model, Ray ray, Func<Model, Action<Ray>> intersect = null)
    {
        var watched = new WatchedRay(ray);
        if (intersect == null) model.Intersect(watched);
        else intersect(model)(watched);
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
