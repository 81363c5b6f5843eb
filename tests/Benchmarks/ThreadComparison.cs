namespace RayCaster.Benchmarks;

/// <summary>What more threads than one gain: our ways and Embree's best of a comparison with more, each with one thread and with as many.</summary>
/// <param name="rays">That comparison, the last that was run: Embree still has its size.</param>
internal sealed class ThreadComparison(RayComparison rays)
{
    private const double Milliseconds = 6000;

    private readonly List<Way[]> pairs =
        new[] { rays.Exact, rays.Bytes, rays.BestEmbree(Answer.Hits), rays.BestEmbree(Answer.Bytes) }
            .OfType<Way>()
            .Select(way => new[] { Twice(way).With(1), Twice(way).With(rays.Threads) })
            .ToList();

    public RayComparison Rays { get; } = rays;

    /// <summary>How many times as fast as one thread all together give an answer; null without Embree.</summary>
    public Ratio? Gain(Answer answer, bool isEmbree = false) =>
        pairs.Find(pair => pair[0].Answer == answer && pair[0].IsEmbree == isEmbree) is [var one, var all] ? Ratio.Of(all, one) : null;

    /// <summary>Measures: what one thread and what all draw follow each other directly.</summary>
    /// <param name="rounds">How often each way runs at least; short frames run more often, for what delays a thread counts more in them.</param>
    /// <returns>This.</returns>
    public ThreadComparison Run(int rounds)
    {
        Interleaving.WarmUp(pairs.SelectMany(pair => pair));
        var round = 2 * pairs.Sum(pair => pair[0].Run() + pair[1].Run());
        rounds = Math.Max(rounds, (int)Math.Min(100, Milliseconds / round));
        Interleaving.Run(pairs, rounds);
        Console.WriteLine($"\n{Rays.Scene.Title}, {Rays.Size}, {Rays.Threads} threads beside one, {rounds} rounds");
        foreach (var pair in pairs)
            Console.WriteLine($"  {pair[0].Median,10:0.00} ms and {pair[1].Median,10:0.00} ms  " +
                $"{Text.Ratio(Ratio.Of(pair[1], pair[0]).Median),7}  {pair[0].Label}");
        return this;
    }

    /// <summary>The second of two frames counts, as in an animation: before the first, a processor that had nothing to do sleeps, and its caches
    /// hold other things.</summary>
    private static Way Twice(Way way) => way with
    {
        Draw = threads =>
        {
            way.Draw(threads);
            return way.Draw(threads);
        },
    };
}
