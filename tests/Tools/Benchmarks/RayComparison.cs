namespace RayCaster.Benchmarks;

/// <summary>One scene, size and number of threads: all ways on the same rays.</summary>
internal sealed class RayComparison(BenchmarkScene scene, int width, int height, int threads)
{
    /// <summary>How many of Embree's ways go from the heats into the comparison, for each answer.</summary>
    private const int Finalists = 3;

    private readonly List<Way> embrees = [];

    public BenchmarkScene Scene { get; } = scene;

    public string Size { get; } = $"{width}×{height}";

    public int Threads { get; } = threads;

    /// <summary>The ways of the engine.</summary>
    public Way[] Own { get; } = [.. OwnWays.All(scene, width, height).Select(way => way.With(threads))];

    /// <summary>The share of pixels where Embree and we agree; NaN without Embree.</summary>
    public double Agreement { get; private set; } = double.NaN;

    /// <summary>The fastest of Embree's ways that give an answer; null without Embree.</summary>
    public Way? BestEmbree(Answer answer) => embrees.Where(way => way.Answer == answer).MinBy(way => way.Median);

    /// <summary>Measures.</summary>
    /// <param name="embree">The peer with this scene, or null.</param>
    /// <param name="rounds">How often each way runs.</param>
    /// <param name="workshop">Where files may be left.</param>
    /// <returns>This.</returns>
    public RayComparison Run(EmbreePeer? embree, int rounds, Workshop workshop)
    {
        if (embree is not null) AddEmbree(embree, workshop);
        Way[] ways = [.. Own, .. embrees];
        Interleaving.WarmUp(ways);
        Interleaving.Run(ways, rounds);

        Console.WriteLine($"\n{Scene.Title}, {Size}, threads: {Threads}, rounds: {rounds}");
        var drawn = Scene.Create(width, height);
        foreach (var manyFrames in (bool[])[false, true])
            Console.WriteLine($"  {(manyFrames ? "many frames" : "one picture")}: {Plan.For(drawn, Threads, manyFrames)}");
        foreach (var way in ways.OrderBy(way => way.Median))
        {
            var ratio = BestEmbree(way.Answer) is { } best ? Text.Ratio(Ratio.Of(way, best).Median) : "";
            Console.WriteLine($"  {way.Median,10:0.00} ms (least {way.Least:0.00})  {ratio,7}  {way.Answer,-5} {way.Name}");
        }
        return this;
    }

    private void AddEmbree(EmbreePeer embree, Workshop workshop)
    {
        embree.Resize(width, height);
        var heats = embree.Ways.OrderBy(HeatOf).ToList();
        foreach (var way in heats.Take(Finalists))
            foreach (var answer in new[] { Answer.Hits, Answer.Bytes })
                embrees.Add(new Way($"Embree, {way}", answer, count => embree.Run(way, answer, count)).With(Threads));
        var (t, model) = embree.Hits(heats[0], workshop.PathOf("hits"), width * height);
        var ours = new Renderer(Scene.Create(width, height)).CastHits();
        Agreement = Checks.Agreement(ours.T, ours.Model, t, model);

        double HeatOf(string way) => Enumerable.Range(0, 3).Min(_ => embree.Run(way, Answer.Hits, Threads));
    }
}
