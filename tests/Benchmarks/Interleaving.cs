namespace RayCaster.Benchmarks;

/// <summary>What a way leaves behind for each pixel.</summary>
internal enum Answer
{
    /// <summary>t and the model.</summary>
    Hits,

    /// <summary>Red, green and blue.</summary>
    Bytes,
}

/// <summary>One way to draw a picture.</summary>
/// <param name="Name">What tables call it.</param>
/// <param name="Answer">What it leaves behind.</param>
/// <param name="Draw">Draws once with a number of threads and returns the milliseconds; what is not to be counted is outside of them.</param>
/// <param name="IsEmbree">Whether it is one of those that ours are compared with.</param>
internal sealed record Way(string Name, Answer Answer, Func<int, double> Draw, bool IsEmbree = false)
{
    /// <summary>A way without a number of threads.</summary>
    public Way(string name, Answer answer, Func<double> draw) : this(name, answer, _ => draw())
    {
    }

    public int Threads { get; private init; } = 1;

    /// <summary>The milliseconds of all its runs, in the order of the rounds.</summary>
    public List<double> Times { get; private init; } = [];

    public double Median => Statistics.Quantile(Times, 0.5);

    public double Least => Times.Min();

    /// <summary>What the console calls it.</summary>
    public string Label => IsEmbree ? $"Embree, {(Answer == Answer.Hits ? "hits" : "bytes")}: {Name}" : Name;

    /// <summary>The same way, which has not run yet.</summary>
    public Way With(int threads) => this with { Threads = threads, Times = [] };

    public double Run() => Draw(Threads);
}

/// <summary>How many times as fast one way is as another.</summary>
internal readonly record struct Ratio(double Median, double LowerQuartile, double UpperQuartile, double OfMinima)
{
    /// <summary>Compares run by run: other work of the machine slows both runs of a round.</summary>
    public static Ratio Of(Way way, Way peer)
    {
        var ratios = peer.Times.Zip(way.Times, (theirs, ours) => theirs / ours).ToList();
        return new(Statistics.Quantile(ratios, 0.5), Statistics.Quantile(ratios, 0.25), Statistics.Quantile(ratios, 0.75), peer.Least / way.Least);
    }
}

/// <summary>Quantiles of a few numbers.</summary>
internal static class Statistics
{
    public static double Quantile(IEnumerable<double> numbers, double part)
    {
        var sorted = numbers.Order().ToArray();
        var place = part * (sorted.Length - 1);
        var below = (int)place;
        return below + 1 < sorted.Length ? sorted[below] + (place - below) * (sorted[below + 1] - sorted[below]) : sorted[below];
    }
}

/// <summary>Runs ways in turn, so that other work of the machine slows all of them.</summary>
internal static class Interleaving
{
    /// <summary>Runs each way until the runtime has compiled it for good and the caches are warm.</summary>
    public static void WarmUp(IEnumerable<Way> ways, double milliseconds = 400)
    {
        foreach (var way in ways)
        {
            var spent = 0.0;
            for (var i = 0; i < 2 || (i < 40 && spent < milliseconds); i++) spent += way.Run();
        }
        Thread.Sleep(150); // the runtime compiles hot methods a tenth of a second after they went quiet
        foreach (var way in ways) way.Run();
    }

    /// <summary>Runs all ways once in each round; every round begins with another.</summary>
    public static void Run(IReadOnlyList<Way> ways, int rounds)
    {
        for (var round = 0; round < rounds; round++)
            for (var i = 0; i < ways.Count; i++)
                ways[(round + i) % ways.Count].Times.Add(ways[(round + i) % ways.Count].Run());
    }
}
