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

        Color Shaded(Model model) => scene.Camera.Shade(new WatchedRay(ray) { HitParameter = ray.HitParameter, HitModel = model });
    }

    /// <summary>For a ray that no camera makes: X(t), which of the conditions of Counts holds, which hit stays, and a plane.</summary>
    private static IEnumerable<(string, Func<object>)> ExamplesOfRay()
    {
        Ray Fresh() => new(new(1, 2, 3), new(0.48, 0.6, -0.64));
        yield return ("X(5)", () => Of(Fresh().At(5)));
        foreach (var (t, bias) in ((double, double)[])[(1, 2), (2, 2), (3, 2), (-1, 0), (0, 0)]) // wherever zNear and zFar are
            yield return ($"isAhead of Counts({(t < 0 ? "−1" : t)}) for Bias = {bias}", () => ((double, double)[])[(-1e9, 1e9), (1e9, -1e9), (t, t)]
                is var ranges && ranges.Any(z => new Ray(Vector3.Zero, Vector3.Zero) { Bias = bias, ZNear = z.Item1, ZFar = z.Item2 }.Counts(t)));
        foreach (var t in (double[])[4, 16, 10, 6, 14]) // whatever the bias is
            yield return ($"isBetween of Counts({t}) for ZNear = 3, ZFar = 7, DepthPerT = 0.5", () => ((double[])[-1e9, 1e9, 0]).Any(bias =>
                new Ray(Vector3.Zero, Vector3.Zero) { Bias = bias, ZNear = 3, ZFar = 7, DepthPerT = 0.5 }.Counts(t)));
        foreach (var (name, calls) in ((string, double[])[])[("Hit(5), Hit(3), Hit(4)", [5, 3, 4]), ("Hit(3), Hit(3)", [3, 3]),
            ("Hit(−3), Hit(NaN)", [-3, double.NaN])])
            yield return ($"HitParameter and HitModel after {name}", () =>
            {
                var hit = Fresh();
                foreach (var (i, t) in calls.Index()) hit.Hit(t, new Sphere(Vector3.Zero, i + 1)); // which number it was
                return $"{hit.HitParameter}, {(hit.HitModel is Sphere { R: var number } ? $"that of call {number}" : "null")}";
            });
        yield return ("plane", () => HitsOf([new Plane(new(3, 3, -1), new(1, 2, -1))], Fresh(), plane => plane.Intersect));
    }

    /// <summary>A slab from each side, from inside, behind, and parallel to it: inside, outside, and on each face.</summary>
    private static IEnumerable<(string, Func<object>)> ExamplesOfSlab() =>
        from of in ((double P, double d)[])[(0, 0.5), (5, -1), (2.5, 0.5), (5, 1), (2, 0), (0, 0), (4, 0), (1, 0), (3, 0)]
        select (FormattableString.Invariant($"Slab(1, 3, {of.P}, {of.d})"), (Func<object>)(() => Aabb.Slab(1, 3, of.P, of.d)));

    private static object Of(Vector3 v) => (v.X, v.Y, v.Z);

    /// <summary>What an operator makes of two vectors, and what these are afterwards.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, Func<Vector3, Vector3, object> compute)
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6); // new ones for each operator, in case that it changes them
        return [(name, () => compute(a, b)), ($"a after {name}", () => Of(a)), ($"b after {name}", () => Of(b))];
    }

    /// <summary>Each t with which a model calls Hit, and whether it counts; of a sphere by both solutions; of a box also its slabs.</summary>
    private static IEnumerable<(string, Func<object>)> CallsOf(string name, RayCaster.Model model, Func<Ray> ray)
    {
        yield return (name, () => HitsOf(SceneFile.PartsOf(model), ray(), part => part.Intersect));
        if (model is RayCaster.Model<RayCaster.Sphere>)
            yield return ($"{name} analytical", () => HitsOf(SceneFile.PartsOf(model), ray(), part => ((Sphere)part).AnalyticalSolution));
        if (model is RayCaster.Model<RayCaster.Aabb>)
            yield return ($"{name} slabs", () => SlabsOf((Aabb)SceneFile.PartsOf(model).Single(), ray()));
    }

    /// <summary>Of each axis, what Slab returns; then with what Intersect calls Hit, if the box is endless along the other axes.</summary>
    private static double[] SlabsOf(Aabb box, Ray ray)
    {
        const double far = 1e9;
        var (B0, B1, P, d) = (box.B0, box.B1, ray.Origin, ray.Direction);
        (double, double)[] slabs = [Aabb.Slab(B0.X, B1.X, P.X, d.X), Aabb.Slab(B0.Y, B1.Y, P.Y, d.Y), Aabb.Slab(B0.Z, B1.Z, P.Z, d.Z)];
        Aabb[] endless = [new(new(B0.X, -far, -far), new(B1.X, far, far)), new(new(-far, B0.Y, -far), new(far, B1.Y, far)),
            new(new(-far, -far, B0.Z), new(far, far, B1.Z))];
        var byIntersect = endless.Select(slab => HitsOf([slab], ray, part => part.Intersect))
            .Select(hits => hits is [var (first, _), var (second, _)] ? (first, second) : (double.NaN, double.NaN));
        return [.. slabs.Concat(byIntersect).SelectMany(slab => (double[])[slab.Item1, slab.Item2])];
    }

    private static (double, bool)[] HitsOf(IEnumerable<Model> parts, Ray ray, Func<Model, Action<Ray>> intersect)
    {
        var watched = new WatchedRay(ray);
        foreach (var part in parts) intersect(part)(watched);
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
