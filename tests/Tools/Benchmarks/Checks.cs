namespace RayCaster.Benchmarks;

/// <summary>Before anything is timed: all ways draw the same pictures.</summary>
internal static class Checks
{
    private const int Width = 200, Height = 150;
    private const double Crossings = 2e7; // of the definition

    /// <exception cref="InvalidOperationException">A way draws something else.</exception>
    public static void Run(BenchmarkScene benchmark, EmbreePeer? embree, Workshop workshop)
    {
        var scene = benchmark.Create(Width, Height);
        var map = new Renderer(scene).CastHits();
        var (t, model) = (map.T, map.Model);
        var bytes = Renderer.Render(benchmark.Create(Width, Height)).Rgb;
        var step = Math.Max(1, (int)(t.Length * (double)benchmark.ModelCount / Crossings)) | 1; // odd: spread over the columns, too
        int rays = 0, hits = 0;
        for (var i = 0; i < t.Length; i += step, rays++)
        {
            var hit = ScalarRenderer.Cast(scene, i % Width, Height - 1 - i / Width);
            if (hit != map[i] || scene.Shade(hit).ToBytes() != (bytes[3 * i], bytes[3 * i + 1], bytes[3 * i + 2]))
                throw new InvalidOperationException($"{benchmark.Name}: the engine and its definition differ in pixel {i % Width}, {i / Width}");
            if (hit.Model >= 0) hits++;
        }
        Console.WriteLine($"{benchmark.Title}: engine and definition agree to the bit in {rays} of {rays} pixels, {hits} of them hits");

        if (embree is null) return;
        embree.Resize(Width, Height);
        foreach (var way in embree.Ways)
        {
            var (theirT, theirModel) = embree.Hits(way, workshop.PathOf("hits"), t.Length);
            if (Agreement(t, model, theirT, theirModel) is < 0.99 and var share)
                throw new InvalidOperationException($"{benchmark.Name}: Embree's way {way} agrees only in {100 * share:0.00} % of the pixels");
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
