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
internal sealed record Way(string Name, Answer Answer, Func<int, double> Draw)
{
    private int threads = 1;

    /// <summary>The milliseconds of all its runs, in the order of the rounds.</summary>
    public List<double> Times { get; private init; } = [];

    public double Median => Ratio.Quantile(Times, 0.5);

    public double Least => Times.Min();

    /// <summary>The same way, which has not run yet.</summary>
    public Way With(int threads) => this with { threads = threads, Times = [] };

    public double Run() => Draw(threads);
}

/// <summary>How many times as fast one way is as another.</summary>
internal readonly record struct Ratio(double Median, double LowerQuartile, double UpperQuartile, double OfMinima)
{
    /// <summary>Compares run by run: other work of the machine slows both runs of a round.</summary>
    public static Ratio Of(Way way, Way peer)
    {
        var ratios = peer.Times.Zip(way.Times, (theirs, ours) => theirs / ours).ToList();
        return new(Quantile(ratios, 0.5), Quantile(ratios, 0.25), Quantile(ratios, 0.75), peer.Least / way.Least);
    }

    /// <summary>The median, the quartiles and the ratio of the minima.</summary>
    public override string ToString() => $"**{Short(Median)}** ({Short(LowerQuartile)}–{Short(UpperQuartile)}; {Short(OfMinima)})";

    /// <summary>Three digits: 12.3, 1.23, 0.123.</summary>
    public static string Short(double number) => number.ToString("F" + Math.Clamp(2 - (int)Math.Floor(Math.Log10(number)), 0, 8));

    public static double Quantile(IEnumerable<double> numbers, double part)
    {
        var sorted = numbers.Order().ToArray();
        var (below, rest) = ((int)(part * (sorted.Length - 1)), part * (sorted.Length - 1) % 1);
        return rest == 0 ? sorted[below] : sorted[below] + rest * (sorted[below + 1] - sorted[below]);
    }
}

/// <summary>Runs ways in turn, so that other work of the machine slows all of them.</summary>
internal static class Interleaving
{
    /// <summary>Runs each way until the runtime has compiled it for good and the caches are warm.</summary>
    public static void WarmUp(IReadOnlyList<Way> ways, double milliseconds = 400)
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
