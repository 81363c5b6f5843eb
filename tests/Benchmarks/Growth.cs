namespace RayCaster.Benchmarks;

/// <summary>How time grows with models, pixels and threads: charts.</summary>
internal sealed class Growth(Options options, Workshop workshop, string? peer)
{
    private readonly (int Width, int Height) size = options.Quick ? (500, 500) : (1920, 1080);
    private readonly int mostModels = options.Quick ? 10_000 : options.Largest ? int.MaxValue : 10_000_000;
    private readonly int mostPixels = options.Quick ? 1_000_000 : options.Largest ? 100_000_000 : 10_000_000;
    private readonly string largeMesh = options.Quick ? "bumpy-1k" : "bumpy-1m";
    private readonly int rounds = options.Quick ? 2 : Math.Min(5, options.Repeats);

    private string Size => $"{size.Width}×{size.Height}";

    private string MeshText => options.Quick ? "1 k triangles" : "1 M triangles";

    /// <summary>Meshes of 4 m (m − 1) triangles: from 8 to 10 or 30 million.</summary>
    private IEnumerable<BenchmarkScene> Meshes => new[] { 2, 6, 16, 50, 158, 500, 1581, 2739 }.Where(m => 4 * m * (m - 1) <= mostModels)
        .Select(m => BenchmarkScene.Bumpy($"bumpy-{m}", m));

    private IEnumerable<BenchmarkScene> Crowds => new[] { 10, 100, 1000, 10_000, 100_000, 1_000_000, 3_000_000 }.Where(n => n <= mostModels)
        .Select(n => BenchmarkScene.Spheres($"spheres-{n}", n));

    public IEnumerable<Chart> Run() =>
    [
        Models("growth-triangles", "A bumpy sphere of more and more triangles", "triangles", Meshes),
        Models("growth-spheres", "More and more spheres", "spheres", Crowds),
        Pixels(),
        Threads(),
    ];

    /// <summary>How much memory the first frame takes. To be measured first, because pools keep what a picture needed.</summary>
    public Chart Memory()
    {
        const int Megabyte = 1 << 20;
        var chart = new Chart("growth-memory", $"Memory beside the scene's own, {Size}, one thread", "triangles or spheres", "megabytes");
        var map = new HitMap(size.Width, size.Height);
        Peak(BenchmarkScene.Bumpy("small", 10)); // compiles the code, and touches what receives the hits
        foreach (var (kind, scenes, dashed) in new[] { ("triangles", Meshes, false), ("spheres", Crowds, true) })
        {
            foreach (var benchmark in scenes.Where(scene => scene.ModelCount >= 1000))
            {
                if (benchmark.Mesh is { } mesh)
                    chart.Add(
                        "the mesh itself", Ink.Scalar, benchmark.ModelCount, (24.0 * mesh.Vertices.Length + 4.0 * mesh.Indices.Length) / Megabyte);
                chart.Add($"drawing the {kind}", Ink.Exact, benchmark.ModelCount, Peak(benchmark) / Megabyte, dashed);
            }
        }
        return chart;

        double Peak(BenchmarkScene benchmark)
        {
            var renderer = new Renderer(benchmark.Create(size.Width, size.Height), 1);
            return PeakMemory.Of(() => renderer.CastHits(map));
        }
    }

    private Chart Models(string file, string title, string unit, IEnumerable<BenchmarkScene> scenes)
    {
        var chart = new Chart(file, $"{title}, {Size}, one thread", unit, "milliseconds");
        foreach (var scene in scenes)
        {
            using var embree = peer is null ? null : workshop.StartEmbree(peer, scene, buildThreads: 1, withCompact: false);
            var c = new RayComparison(scene, size.Width, size.Height, 1).Run(embree, rounds, withDefinitions: scene.ModelCount <= 10_000, workshop);
            chart.Add("RayCaster, exact t", Ink.Exact, scene.ModelCount, c.Exact.Median);
            chart.Add("RayCaster, bytes", Ink.Bytes, scene.ModelCount, c.Bytes.Median);
            if (c.BestEmbree(Answer.Hits) is { } best)
            {
                chart.Add("Embree, best way", Ink.Embree, scene.ModelCount, best.Median);
                chart.Add("Embree with its build", Ink.Embree, scene.ModelCount, best.Median * (1 + c.BuildPerTrace), dashed: true);
            }
            if (c.NaiveStruct is { } naive) chart.Add("naive, struct Vector3", Ink.Naive, scene.ModelCount, naive.Median);
            if (c.Scalar is { } scalar) chart.Add("scalar definition", Ink.Scalar, scene.ModelCount, scalar.Median);
        }
        return chart;
    }

    private Chart Pixels()
    {
        var chart = new Chart("growth-pixels", "Larger and larger pictures, one thread", "pixels", "milliseconds");
        var sides = new[] { 100, 316, 1000, 3162, 10_000 }.Where(side => side * side <= mostPixels).ToArray();
        foreach (var scene in new[] { BenchmarkScene.Named("room"), BenchmarkScene.Named(largeMesh) })
        {
            using var embree = peer is null ? null : workshop.StartEmbree(peer, scene, Environment.ProcessorCount, withCompact: false);
            var dashed = scene.Mesh is not null;
            var label = dashed ? MeshText : "room";
            foreach (var side in sides)
            {
                var c = new RayComparison(scene, side, side, 1).Run(embree, rounds, withDefinitions: false, workshop);
                var pixels = (double)side * side;
                chart.Add($"{label}: exact t", Ink.Exact, pixels, c.Exact.Median, dashed);
                chart.Add($"{label}: bytes", Ink.Bytes, pixels, c.Bytes.Median, dashed);
                if (c.BestEmbree(Answer.Hits) is { } best) chart.Add($"{label}: Embree", Ink.Embree, pixels, best.Median, dashed);
            }
        }
        return chart;
    }

    private Chart Threads()
    {
        var chart = new Chart("growth-threads", $"More and more threads, {Size}", "threads", "times as fast as one thread", logarithmic: false);
        foreach (var scene in new[] { BenchmarkScene.Named("room"), BenchmarkScene.Named(largeMesh) })
        {
            using var embree = peer is null ? null : workshop.StartEmbree(peer, scene, Environment.ProcessorCount, withCompact: false);
            var dashed = scene.Mesh is not null;
            var label = dashed ? MeshText : "room";
            Add(1, null);
            for (var threads = 2; threads <= Environment.ProcessorCount; threads = threads < 4 ? threads + 1 : threads * 2)
            {
                var c = new RayComparison(scene, size.Width, size.Height, threads).Run(embree, rounds, withDefinitions: false, workshop);
                Add(threads, new ThreadComparison(c).Run(3 * rounds));
            }

            void Add(int threads, ThreadComparison? c)
            {
                if (!dashed) chart.Add("each thread a full one", Ink.Scalar, threads, threads, dashed: true);
                chart.Add($"{label}: exact t", Ink.Exact, threads, c?.Gain(Answer.Hits)?.Median ?? 1, dashed);
                chart.Add($"{label}: bytes", Ink.Bytes, threads, c?.Gain(Answer.Bytes)?.Median ?? 1, dashed);
                if (embree is not null)
                    chart.Add($"{label}: Embree", Ink.Embree, threads, c?.Gain(Answer.Hits, isEmbree: true)?.Median ?? 1, dashed);
            }
        }
        return chart;
    }
}
