namespace RayCaster.Teaching;

/// <summary>
/// Measures how far the pictures of wrong programs are from a program's pictures, and sorts them. Each round compares more pixels of fewer
/// candidates, so most candidates that are far off cost a hundred rays.
/// </summary>
/// <remarks>
/// For one picture the wrong pixels are counted. Of several pictures each counts 1 at most (<see cref="Evidence.Loss"/>): a picture that nothing
/// explains does not hide what explains the others, and a mistake that would show in a right picture is dropped.
/// </remarks>
/// <param name="pictures">The pictures, each of another scene.</param>
/// <param name="threads">How many threads draw; one per core if null.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
internal sealed class CandidateRanking(IReadOnlyList<Evidence> pictures, int? threads, Predicate<Mistake>? likely)
{
    /// <summary>The search ends if a mistake leaves at most this share of all that is wrong unexplained.</summary>
    private const double Explained = 0.02;

    /// <summary>The share of all that is wrong that another program's rounding may leave: of one picture's pixels, and of several pictures' losses.
    /// </summary>
    private const double RoundingOfOne = 0.004, RoundingOfSeveral = 0.01;

    /// <summary>Of several mistakes, each must explain this share of all that is wrong, or it is not named.</summary>
    public const double Idle = 0.002;

    /// <summary>The share of the evidence for a screening of hundreds of candidates or more: some thirty pixels.</summary>
    public const double Screening = 0.005;

    /// <summary>The share of the evidence that each round compares, and how many candidates it has at least.</summary>
    private static readonly (double Share, int Candidates)[] rounds = [(0.012, int.MaxValue), (0.1, 60), (1, 12)];

    /// <summary>With more candidates than this, most are dropped after a screening.</summary>
    private const int Many = 2000;

    /// <summary>The factor by which an unlikely mistake costs more. It decides between mistakes that explain a picture almost equally well; two
    /// likely mistakes still cost more than one unlikely one.</summary>
    private const double Unlikely = 1.5;

    private readonly double rounding = pictures.Count == 1 ? RoundingOfOne : RoundingOfSeveral;

    /// <summary>How long comparisons may take; null for any time.</summary>
    public SearchBudget? Budget { get; set; }

    /// <summary>The candidates that were compared with all evidence, in no order.</summary>
    public List<WrongProgram> Closest { get; } = [];

    /// <summary>All that is wrong: the wrong pixels of one picture, or how many of several are wrong.</summary>
    public double Wrong { get; } = pictures is [var only] ? only.WrongCount : pictures.Count(picture => !picture.IsRight);

    /// <summary>Whether a candidate leaves so little that the search may end.</summary>
    public bool IsDone(List<WrongProgram> all, double left = Explained) => all.Exists(candidate => candidate.Misfit.Unexplained <= left * Wrong);

    /// <summary>Whether no second mistake could be worth its <see cref="WrongProgram.Cost"/>.</summary>
    public bool IsCertain(List<WrongProgram> all) => all.Exists(candidate => candidate.Misfit.Unexplained <= candidate.LeastLeft(Wrong, rounding));

    /// <summary>The best first. Of equals the first is that with the usual variants, and of these the first in the catalogue.</summary>
    public List<WrongProgram> Sorted(List<WrongProgram> candidates) =>
        [.. candidates.OrderBy(candidate => candidate.Cost(Wrong, rounding) * PriorPenalty(candidate)).ThenBy(candidate => candidate.Unusual)];

    private double PriorPenalty(WrongProgram candidate) =>
        likely is null ? 1 : Math.Pow(Unlikely, candidate.Mistakes.Count(mistake => !likely(mistake)));

    /// <summary>The same with more pixels in the first round, because a second mistake may explain only a few.</summary>
    public List<WrongProgram> BestPairs(List<WrongProgram> pairs) => Best(pairs, [(0.04, int.MaxValue), .. rounds[1..]]);

    /// <summary>Compares all candidates, then the best ones more closely, and sorts these.</summary>
    public List<WrongProgram> Best(List<WrongProgram> candidates, (double Share, int Candidates)[]? otherRounds = null)
    {
        if (candidates.Count > Many) candidates = Measured(candidates, Screening)[..(candidates.Count / 4)];
        foreach (var (share, most) in otherRounds ?? rounds)
        {
            var kept = Math.Min(candidates.Count, most == int.MaxValue ? most : Math.Max(most, share < 1 ? candidates.Count / 8 : most));
            candidates = Measured(candidates[..kept], share);
        }
        return candidates;
    }

    /// <summary>Compares all candidates, with a share of the evidence, and sorts them.</summary>
    /// <param name="left">The evidence; the pictures' own if null.</param>
    /// <exception cref="TimeoutException">The time is over.</exception>
    public List<WrongProgram> Measured(List<WrongProgram> candidates, double share, IReadOnlyList<Evidence>? left = null)
    {
        var measured = new WrongProgram[candidates.Count];
        Parallel.For(0, candidates.Count, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, (i, loop) =>
        {
            if (Budget?.IsSpent() == true) loop.Stop();
            else measured[i] = candidates[i] with { Misfit = Measure(candidates[i], share, left) };
        });
        Budget?.ThrowIfSpent();
        if (share == 1 && left is null) Closest.AddRange(measured);
        return Sorted([.. measured]);
    }

    /// <summary>How far a candidate is from a share of the evidence.</summary>
    public Misfit Measure(WrongProgram candidate, double share, IReadOnlyList<Evidence>? left = null)
    {
        var among = left ?? pictures;
        return among is [var only] ? only.Misfit(candidate.For(only.Scene), share)
            : new(among.Sum(picture => picture.Loss(picture.Misfit(candidate.For(picture.Scene), share))), 0);
    }

    /// <summary>The candidates that a few pixels do not rule out.</summary>
    public List<WrongProgram> Plausible(Func<WrongProgram, bool> may, IEnumerable<WrongProgram> candidates) =>
    [
        .. candidates.TakeWhile(_ => Budget?.IsSpent() != true)
            .AsParallel().AsOrdered().WithDegreeOfParallelism(threads ?? Environment.ProcessorCount).Where(may),
    ];

    /// <summary>Drops mistakes and missing parts without which as much is explained.</summary>
    public WrongProgram WithoutIdle(WrongProgram candidate)
    {
        if (candidate.Variants.Count + candidate.Base.NotYet.Count < (candidate is { OtherSample: true, Variants: [] } ? 1 : 2)) return candidate;
        foreach (var less in candidate.Less)
        {
            var misfit = Measure(less, 1);
            if (misfit.Unexplained <= candidate.Misfit.Unexplained + Idle * Wrong) return WithoutIdle(less with { Misfit = misfit });
        }
        return candidate;
    }
}
