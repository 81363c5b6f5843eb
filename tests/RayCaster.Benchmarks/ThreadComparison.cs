namespace RayCaster.Benchmarks;

/// <summary>What more threads than one gain: our ways and Embree's best of a comparison with more, each with one thread and with as many.</summary>
/// <param name="rays">That comparison, the last that was run: Embree still has its size.</param>
internal sealed class ThreadComparison(RayComparison rays)
{
    private readonly List<Way[]> pairs =
        new[] { rays.Exact, rays.Bytes, rays.BestEmbree(Answer.Hits), rays.BestEmbree(Answer.Bytes) }
            .OfType<Way>()
            .Select(way => new[] { way.With(1), way.With(rays.Threads) })
            .ToList();

    public RayComparison Rays { get; } = rays;

    /// <summary>How many times as fast as one thread all together give an answer; null without Embree.</summary>
    public Ratio? Gain(Answer answer, bool isEmbree = false) =>
        pairs.Find(pair => pair[0].Answer == answer && pair[0].IsEmbree == isEmbree) is [var one, var all] ? Ratio.Of(all, one) : null;

    /// <summary>Measures: what one thread and what all draw follow each other directly.</summary>
    /// <param name="rounds">How often each way runs.</param>
    /// <returns>This.</returns>
    public ThreadComparison Run(int rounds)
    {
        Interleaving.WarmUp(pairs.SelectMany(pair => pair));
        Interleaving.Run(pairs, rounds);
        Console.WriteLine($"\n{Rays.Scene.Title}, {Rays.Size}, {Rays.Threads} threads beside one, {rounds} rounds");
        foreach (var pair in pairs)
            Console.WriteLine($"  {pair[0].Median,10:0.00} ms and {pair[1].Median,10:0.00} ms  {Text.Ratio(Ratio.Of(pair[1], pair[0]).Median),7}  {pair[0].Label}");
        return this;
    }
}
