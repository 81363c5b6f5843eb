namespace RayCaster.Benchmarks;

/// <summary>One scene, size and number of threads: all ways on the same rays.</summary>
internal sealed class RayComparison(BenchmarkScene scene, int width, int height, int threads)
{
    /// <summary>How many of Embree's ways go from the heats into the comparison, for each answer.</summary>
    private const int Finalists = 3;

    private readonly List<Way> ways = [];

    public BenchmarkScene Scene { get; } = scene;

    public string Size { get; } = $"{width}×{height}";

    public int Threads { get; } = threads;

    public Way Exact { get; } = OwnWays.Exact(scene, width, height).With(threads);

    public Way Bytes { get; } = OwnWays.Bytes(scene, width, height).With(threads);

    /// <summary>The same with models that earlier frames have drawn, from other sides.</summary>
    public Way LaterExact { get; } = OwnWays.LaterExact(scene, width, height).With(threads);

    /// <inheritdoc cref="LaterExact"/>
    public Way LaterBytes { get; } = OwnWays.LaterBytes(scene, width, height).With(threads);

    /// <summary>What README's command runs: without the kernels that pay only for many frames.</summary>
    public Way SinglePicture { get; } = OwnWays.SinglePicture(scene, width, height).With(threads);

    /// <summary>The definition and the naive peers, which know one thread; null where they are left out.</summary>
    public Way? Scalar { get; private set; }

    /// <inheritdoc cref="Scalar"/>
    public Way? NaiveStruct { get; private set; }

    /// <inheritdoc cref="Scalar"/>
    public Way? NaiveClass { get; private set; }

    /// <summary>How long Embree's best way took to build its hierarchy, in units of its own tracing.</summary>
    public double BuildPerTrace { get; private set; } = double.NaN;

    /// <summary>The share of pixels where Embree and we agree; NaN without Embree.</summary>
    public double Agreement { get; private set; } = double.NaN;

    /// <summary>The fastest of Embree's ways that give an answer; null without Embree.</summary>
    public Way? BestEmbree(Answer answer) => ways.Where(way => way.IsEmbree && way.Answer == answer).MinBy(way => way.Median);

    /// <summary>Measures.</summary>
    /// <param name="embree">The peer with this scene, or null.</param>
    /// <param name="rounds">How often each way runs.</param>
    /// <param name="workshop">Where files may be left.</param>
    /// <returns>This.</returns>
    public RayComparison Run(EmbreePeer? embree, int rounds, Workshop workshop)
    {
        ways.AddRange([Exact, Bytes, LaterExact, LaterBytes, SinglePicture]);
        if (Threads == 1)
        {
            ways.Add(Scalar = OwnWays.Scalar(Scene, width, height));
            if (Scene.ModelCount <= 2_000_000) // ten million objects of objects are more than a machine should be asked for
            {
                ways.Add(NaiveStruct = OwnWays.NaiveStruct(Scene, width, height));
                ways.Add(NaiveClass = OwnWays.NaiveClass(Scene, width, height));
            }
        }
        if (embree is not null) AddEmbree(embree, workshop);
        Interleaving.WarmUp(ways);
        Interleaving.Run(ways, rounds);
        Print();
        return this;
    }

    private void AddEmbree(EmbreePeer embree, Workshop workshop)
    {
        embree.Resize(width, height);
        var heats = embree.Ways.Select(way => (Way: way, Time: HeatOf(embree, way))).OrderBy(heat => heat.Time).ToList();
        foreach (var (way, _) in heats.Take(Finalists))
            foreach (var answer in new[] { Answer.Hits, Answer.Bytes })
                ways.Add(new Way(embree.NameOf(way), answer, count => embree.Run(way, answer, count), IsEmbree: true).With(Threads));
        var best = heats[0];
        BuildPerTrace = embree.Build(best.Way[..best.Way.LastIndexOf(' ')]) / best.Time;

        var (t, model) = embree.Hits(best.Way, workshop.PathOf("hits"), width * height);
        var ours = new Renderer(Scene.Create(width, height)).CastHits();
        Agreement = Checks.Agreement(ours.T, ours.Model, t, model);
    }

    private double HeatOf(EmbreePeer embree, string way)
    {
        embree.Run(way, Answer.Hits, Threads);
        return Math.Min(embree.Run(way, Answer.Hits, Threads), embree.Run(way, Answer.Hits, Threads));
    }

    private void Print()
    {
        Console.WriteLine($"\n{Scene.Title}, {Size}, {Threads} {(Threads == 1 ? "thread" : "threads")}, {Exact.Times.Count} rounds");
        var drawn = Scene.Create(width, height);
        foreach (var manyFrames in (bool[])[false, true])
            Console.WriteLine($"  {(manyFrames ? "many frames" : "one picture")}: {Plan.For(drawn, Threads, manyFrames)}");
        if (!double.IsNaN(Agreement))
            Console.WriteLine($"  Embree sees as far as we see in {100 * Agreement:0.000} % of the pixels; " +
                $"its hierarchy takes {Text.Ratio(BuildPerTrace)} times its tracing");
        foreach (var way in ways.OrderBy(way => way.Median))
        {
            var best = BestEmbree(way.Answer);
            Console.WriteLine($"  {way.Median,10:0.00} ms (least {way.Least:0.00})  " +
                $"{(best is null ? "" : Text.Ratio(Ratio.Of(way, best).Median)),7}  {way.Label}");
        }
    }
}
