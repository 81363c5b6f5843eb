namespace RayCaster.Teaching;

/// <summary>
/// Measures how far the pictures of wrong programs are from a program's pictures, and sorts them. Each round compares more pixels of fewer trials,
/// so most trials that are far off cost a hundred rays.
/// </summary>
/// <remarks>
/// For one picture the wrong pixels are counted. Of several pictures each counts 1 at most (<see cref="Evidence.Loss"/>): a picture that nothing
/// explains does not hide what explains the others, and a mistake that would show in a right picture is dropped.
/// </remarks>
/// <param name="pictures">The pictures, each of another scene.</param>
/// <param name="threads">How many threads draw; one per core if null.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
internal sealed class TrialRanking(IReadOnlyList<Evidence> pictures, int? threads, Predicate<Mistake>? likely)
{
    /// <summary>The search ends if a mistake leaves at most this share of all that is wrong unexplained.</summary>
    private const double Explained = 0.02;

    /// <summary>The share of all that is wrong that another program's rounding may leave: of one picture's pixels, and of several pictures' losses.
    /// </summary>
    private const double RoundingOfOne = 0.004, RoundingOfSeveral = 0.01;

    /// <summary>Of several mistakes, each must explain this share of all that is wrong, or it is not named.</summary>
    public const double Idle = 0.002;

    /// <summary>The share of the evidence for a first look at hundreds of trials or more: some thirty pixels.</summary>
    public const double Glance = 0.005;

    /// <summary>The share of the evidence that each round compares, and how many trials it has at least.</summary>
    private static readonly (double Share, int Trials)[] rounds = [(0.012, int.MaxValue), (0.1, 60), (1, 12)];

    /// <summary>With more trials than this, most are dropped after a first look.</summary>
    private const int Many = 2000;

    /// <summary>The factor by which an unlikely mistake costs more. It decides between mistakes that explain a picture almost equally well; two
    /// likely mistakes still cost more than one unlikely one.</summary>
    private const double Unlikely = 1.5;

    private readonly double rounding = pictures.Count == 1 ? RoundingOfOne : RoundingOfSeveral;

    /// <summary>How long comparisons may take; null for any time.</summary>
    public SearchBudget? Budget { get; set; }

    /// <summary>The trials that were compared with all evidence, in no order.</summary>
    public List<WrongProgram> Closest { get; } = [];

    /// <summary>All that is wrong: the wrong pixels of one picture, or how many of several are wrong.</summary>
    public double Wrong { get; } = pictures is [var only] ? only.WrongCount : pictures.Count(picture => !picture.IsRight);

    /// <summary>Whether a trial leaves so little that the search may end.</summary>
    public bool IsDone(List<WrongProgram> all, double left = Explained) => all.Exists(trial => trial.Misfit.Unexplained <= left * Wrong);

    /// <summary>Whether no second mistake could be worth its <see cref="WrongProgram.Cost"/>.</summary>
    public bool IsCertain(List<WrongProgram> all) => all.Exists(trial => trial.Misfit.Unexplained <= trial.LeastLeft(Wrong, rounding));

    /// <summary>The best first. Of equals the first is that with the usual wordings, and of these the first in the catalogue.</summary>
    public List<WrongProgram> Sorted(List<WrongProgram> trials) =>
        [.. trials.OrderBy(trial => trial.Cost(Wrong, rounding) * Surprise(trial)).ThenBy(trial => trial.Unusual)];

    private double Surprise(WrongProgram trial) => likely is null ? 1 : Math.Pow(Unlikely, trial.Mistakes.Count(mistake => !likely(mistake)));

    /// <summary>The same with more pixels in the first round, because a second mistake may explain only a few.</summary>
    public List<WrongProgram> BestPairs(List<WrongProgram> pairs) => Best(pairs, [(0.04, int.MaxValue), .. rounds[1..]]);

    /// <summary>Compares all trials, then the best ones more closely, and sorts these.</summary>
    public List<WrongProgram> Best(List<WrongProgram> trials, (double Share, int Trials)[]? otherRounds = null)
    {
        if (trials.Count > Many) trials = Measured(trials, Glance)[..(trials.Count / 4)];
        foreach (var (share, most) in otherRounds ?? rounds)
        {
            var kept = Math.Min(trials.Count, most == int.MaxValue ? most : Math.Max(most, share < 1 ? trials.Count / 8 : most));
            trials = Measured(trials[..kept], share);
        }
        return trials;
    }

    /// <summary>Compares all trials, with a share of the evidence, and sorts them.</summary>
    /// <param name="left">The evidence; the pictures' own if null.</param>
    /// <exception cref="TimeoutException">The time is over.</exception>
    public List<WrongProgram> Measured(List<WrongProgram> trials, double share, IReadOnlyList<Evidence>? left = null)
    {
        var measured = new WrongProgram[trials.Count];
        Parallel.For(0, trials.Count, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, (i, loop) =>
        {
            if (Budget?.IsSpent() == true) loop.Stop();
            else measured[i] = trials[i] with { Misfit = Measure(trials[i], share, left) };
        });
        Budget?.ThrowIfSpent();
        if (share == 1 && left is null) Closest.AddRange(measured);
        return Sorted([.. measured]);
    }

    /// <summary>How far a trial is from a share of the evidence.</summary>
    public Misfit Measure(WrongProgram trial, double share, IReadOnlyList<Evidence>? left = null)
    {
        var among = left ?? pictures;
        return among is [var only] ? only.Misfit(trial.Draw(only.Scene), share)
            : new(among.Sum(picture => picture.Loss(picture.Misfit(trial.Draw(picture.Scene), share))), 0);
    }

    /// <summary>The trials that a few pixels do not rule out.</summary>
    public List<WrongProgram> Those(Func<WrongProgram, bool> may, IEnumerable<WrongProgram> trials) =>
    [
        .. trials.TakeWhile(_ => Budget?.IsSpent() != true)
            .AsParallel().AsOrdered().WithDegreeOfParallelism(threads ?? Environment.ProcessorCount).Where(may),
    ];

    /// <summary>Drops mistakes and missing parts without which as much is explained.</summary>
    public WrongProgram WithoutIdle(WrongProgram trial)
    {
        if (trial.Wordings.Count + trial.Base.NotYet.Count < (trial is { OtherSample: true, Wordings: [] } ? 1 : 2)) return trial;
        foreach (var less in trial.Less)
        {
            var misfit = Measure(less, 1);
            if (misfit.Unexplained <= trial.Misfit.Unexplained + Idle * Wrong) return WithoutIdle(less with { Misfit = misfit });
        }
        return trial;
    }
}
