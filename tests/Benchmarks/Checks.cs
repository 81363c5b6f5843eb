namespace RayCaster.Benchmarks;

/// <summary>Before anything is timed: all ways draw the same pictures.</summary>
internal static class Checks
{
    private const int Width = 200, Height = 150;

    /// <exception cref="InvalidOperationException">A way draws something else.</exception>
    public static void Run(BenchmarkScene benchmark, EmbreePeer? embree, Workshop workshop)
    {
        var scene = benchmark.Create(Width, Height);
        var map = new Renderer(scene).CastHits();
        var (t, model) = (map.T, map.Model);
        var bytes = Renderer.Render(benchmark.Create(Width, Height)).Rgb;
        var step = OwnWays.Step(benchmark, Width, Height);
        int rays = 0, hits = 0;
        for (var i = 0; i < t.Length; i += step, rays++)
        {
            var ray = ScalarRenderer.Cast(scene, i % Width, Height - 1 - i / Width);
            var hitModel = model[i] < 0 ? null : scene.Models[model[i]];
            var rgb = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
            if (ray.HitModel != hitModel || (hitModel is not null && ray.HitParameter != t[i])
                || rgb != (bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]))
                throw new InvalidOperationException($"{benchmark.Name}: the engine and its definition differ in pixel {i % Width}, {i / Width}");
            if (hitModel is not null) hits++;
        }
        Console.WriteLine($"{benchmark.Title}: engine and definition agree to the bit in {rays} of {rays} pixels, {hits} of them hits");

        if (benchmark.ModelCount <= 2_000_000)
        {
            Compare("naive, class Vector3", OwnWays.WithClasses(scene));
            Compare("naive, struct Vector3", OwnWays.WithStructs(scene));
        }

        if (embree is null) return;
        embree.Resize(Width, Height);
        var worst = (Share: 1.0, Way: "");
        foreach (var way in embree.Ways)
        {
            var (theirT, theirModel) = embree.Hits(way, workshop.PathOf("hits"), t.Length);
            var share = Agreement(t, model, theirT, theirModel);
            if (share < worst.Share) worst = (share, way);
            if (share < 0.99)
                throw new InvalidOperationException($"{benchmark.Name}: Embree's way {way} agrees only in {100 * share:0.00} % of the pixels");
        }
        Console.WriteLine($"  each of Embree's {embree.Ways.Count()} ways agrees in {100 * worst.Share:0.00} % or more of the pixels {worst.Way}");

        void Compare(string name, Func<int, int, (byte R, byte G, byte B)> cast)
        {
            var same = 0;
            for (var i = 0; i < t.Length; i += step)
            {
                var (r, g, b) = cast(i % Width, Height - 1 - i / Width);
                if (Math.Abs(r - bytes[3 * i]) <= 1 && Math.Abs(g - bytes[3 * i + 1]) <= 1 && Math.Abs(b - bytes[3 * i + 2]) <= 1) same++;
            }
            Console.WriteLine($"  {name}: the same colour in {100.0 * same / rays:0.00} % of them");
            if (same < 0.99 * rays) throw new InvalidOperationException($"{benchmark.Name}: {name} draws another picture");
        }
    }

    /// <summary>The share of pixels where a peer that computes in float sees something as far away as we do, or nothing with us.</summary>
    /// <exception cref="InvalidOperationException">It sees other models, in more pixels than those where two meet.</exception>
    public static double Agreement(double[] t, int[] model, float[] theirT, int[] theirModel)
    {
        const double FloatError = 2e-5; // of t: coordinates are rounded to 6e-8, and slanting surfaces make more of it
        int near = 0, same = 0;
        for (var i = 0; i < t.Length; i++)
        {
            if (model[i] == theirModel[i]) same++;
            if (model[i] < 0 ? theirModel[i] < 0 : theirModel[i] >= 0 && Math.Abs(t[i] - theirT[i]) <= FloatError * t[i]) near++;
        }
        if (same < 0.99 * t.Length)
            throw new InvalidOperationException($"Embree sees our models only in {100.0 * same / t.Length:0.0} % of the pixels");
        return (double)near / t.Length;
    }
}
