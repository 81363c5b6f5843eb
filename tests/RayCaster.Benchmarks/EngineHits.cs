namespace RayCaster.Benchmarks;

/// <summary>The engine's exact answer: t and model of every pixel, top line first.</summary>
internal static class EngineHits
{
    public static (double[] T, int[] Model) Cast(Scene scene, int threads)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var (t, model) = (new double[width * height], new int[width * height]);
        var renderer = new Renderer(scene, threads);
        Parallel.For(0, height, new ParallelOptions { MaxDegreeOfParallelism = threads }, () => new RaySpan(scene.Camera), (y, _, span) =>
        {
            for (var x = 0; x < width; x += RaySpan.MaxLength)
            {
                var length = Math.Min(RaySpan.MaxLength, width - x);
                renderer.Cast(span, x, height - 1 - y, length);
                span.T[..length].CopyTo(t.AsSpan(y * width + x));
                for (var i = 0; i < length; i++) model[y * width + x + i] = span.ModelAt(i);
            }
            return span;
        }, _ => { });
        return (t, model);
    }
}
