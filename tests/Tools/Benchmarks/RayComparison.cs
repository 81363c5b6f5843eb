namespace RayCaster.Benchmarks;

/// <summary>One scene and number of threads: all ways on the same rays.</summary>
internal sealed class RayComparison(BenchmarkScene scene, int threads)
{
    private const int Width = 1920, Height = 1080;

    /// <summary>How many of Embree's ways go from the heats into the comparison, for each answer.</summary>
    private const int Finalists = 3;

    private readonly List<Way> embrees = [];

    public BenchmarkScene Scene { get; } = scene;

    public int Threads { get; } = threads;

    /// <summary>The ways of the engine.</summary>
    public Way[] Own { get; } = [.. OwnWays.All(scene, Width, Height).Select(way => way.With(threads))];

    /// <summary>The share of pixels where Embree and we agree; NaN without Embree.</summary>
    public double Agreement { get; private set; } = double.NaN;

    /// <summary>The fastest of Embree's ways that give an answer; null without Embree.</summary>
    public Way? BestEmbree(Answer answer) => embrees.Where(way => way.Answer == answer).MinBy(way => way.Median);

    /// <summary>Measures beside the peer, if there is one, in so many rounds. The peer may write its hits into the file.</summary>
    public RayComparison Run(EmbreePeer? embree, int rounds, string file)
    {
        if (embree is not null) AddEmbree(embree, file);
        Way[] ways = [.. Own, .. embrees];
        Interleaving.WarmUp(ways);
        Interleaving.Run(ways, rounds);

        Console.WriteLine($"\n{Scene.Title}, {Width}×{Height}, threads: {Threads}, rounds: {rounds}");
        var drawn = Scene.Create(Width, Height);
        foreach (var manyFrames in (bool[])[false, true])
            Console.WriteLine($"  {(manyFrames ? "many frames" : "one picture")}: {Plan.For(drawn, Threads, manyFrames)}");
        foreach (var way in ways.OrderBy(way => way.Median))
        {
            var ratio = BestEmbree(way.Answer) is { } best ? Ratio.Short(Ratio.Of(way, best).Median) : "";
            Console.WriteLine($"  {way.Median,10:0.00} ms (least {way.Least:0.00})  {ratio,7}  {way.Answer,-5} {way.Name}");
        }
        return this;
    }

    private void AddEmbree(EmbreePeer embree, string file)
    {
        embree.Resize(Width, Height);
        var heats = embree.Ways.OrderBy(HeatOf).ToList();
        foreach (var way in heats.Take(Finalists))
            foreach (var answer in new[] { Answer.Hits, Answer.Bytes })
                embrees.Add(new Way($"Embree, {way}", answer, count => embree.Run(way, answer, count)).With(Threads));
        var (t, model) = embree.Hits(heats[0], file, Width * Height);
        var ours = new Renderer(Scene.Create(Width, Height)).CastHits();
        Agreement = AgreementOf(ours.T, ours.Model, t, model);

        double HeatOf(string way) => Enumerable.Range(0, 3).Min(_ => embree.Run(way, Answer.Hits, Threads));
    }

    /// <summary>The share of pixels where a peer that computes in float sees something as far away as we do, or nothing with us.</summary>
    /// <exception cref="InvalidOperationException">It sees other models, in more pixels than those where two meet.</exception>
    private static double AgreementOf(double[] t, int[] model, float[] theirT, int[] theirModel)
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
