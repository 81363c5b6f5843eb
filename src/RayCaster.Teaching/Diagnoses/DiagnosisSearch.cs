using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>
/// Tries unfinished programs, each mistake in each of its wordings, and pairs of them, on the <see cref="Evidence"/> of a program's pictures. Each
/// round compares more pixels of fewer trials, so most trials that are far off cost a hundred rays.
/// </summary>
/// <remarks>
/// For one picture the wrong pixels are counted. Of several pictures each counts 1 at most (<see cref="Evidence.Loss"/>): a picture that nothing
/// explains does not hide what explains the others, and a mistake that would show in a right picture is dropped.
/// </remarks>
/// <param name="pictures">The pictures, each of another scene.</param>
/// <param name="done">What the program certainly draws.</param>
/// <param name="threads">How many threads draw; one per core if null.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
internal sealed class DiagnosisSearch(
    IReadOnlyList<Evidence> pictures, IReadOnlyList<Mistake> known, IReadOnlyCollection<string> done, int? threads, Predicate<Mistake>? likely)
{
    /// <summary>The search ends if a mistake leaves at most this share of all that is wrong unexplained.</summary>
    private const double Explained = 0.02;

    /// <summary>The share of all that is wrong that another program's rounding may leave: of one picture's pixels, and of several pictures' losses.
    /// </summary>
    private const double RoundingOfOne = 0.004, RoundingOfSeveral = 0.01;

    /// <summary>If a mistake leaves at most this share, its other wordings are tried once more.</summary>
    private const double Rewordable = 0.1;

    /// <summary>The search ends at this share if shapes are missing, whose pixels a second mistake may explain.</summary>
    private const double Nearly = 0.001;

    /// <summary>Of several mistakes, each must explain this share of all that is wrong, or it is not named.</summary>
    public const double Idle = 0.002;

    /// <summary>The share of the evidence that each round compares, and how many trials it has at least.</summary>
    private static readonly (double Share, int Trials)[] rounds = [(0.012, int.MaxValue), (0.1, 60), (1, 12)];

    /// <summary>The same for mistakes in other manners, of which few fit.</summary>
    private static readonly (double Share, int Trials)[] mannerRounds = [(Glance, int.MaxValue), (0.03, 40), (0.1, 12), (1, 3)];

    /// <summary>How many manners are tried on top of one another, and how many wordings of each mistake are tried in them.</summary>
    private const int Manners = 2, Slips = 16;

    /// <summary>The share of the evidence for a first look at hundreds of trials or more: some thirty pixels.</summary>
    private const double Glance = 0.005;

    /// <summary>With more trials than this, most are dropped after a first look.</summary>
    private const int Many = 2000;

    /// <summary>How many single mistakes are tried together with every other: of a finished program, and of an unfinished one.</summary>
    private const int Partners = 10, UnfinishedPartners = 4;

    /// <summary>How many second mistakes of each first one are compared closely, and how many of all pairs.</summary>
    private const int Seconds = 8, Closer = 100;

    /// <summary>The factor by which an unlikely mistake costs more. It decides between mistakes that explain a picture almost equally well; two
    /// likely mistakes still cost more than one unlikely one.</summary>
    private const double Unlikely = 1.5;

    /// <summary>How many of the nearest mistakes are also tried with rays through the other place of each pixel.</summary>
    private const int OtherSamples = 6;

    /// <summary>How many of the nearest mistakes are tried beside each way to be unfinished.</summary>
    private const int Besides = 3;

    /// <summary>How many ways to be unfinished are tried together with mistakes.</summary>
    private const int Ways = 8;

    /// <summary>Mistakes that come after others that draw the same picture, because fewer people make them.</summary>
    private static readonly string[] rare = ["v-cross", "clip-root", "znear-t", "zfar-t"];

    private static readonly Mistake center = MistakeCatalog.Named("center")!;

    private readonly Mistake[] known = [.. known.OrderBy(mistake => rare.Contains(mistake.Id))];

    private readonly string[] kinds = Unfinished.KindsOf(pictures);

    private readonly double rounding = pictures.Count == 1 ? RoundingOfOne : RoundingOfSeveral;

    private List<WrongProgram>? nearestByColors; // of every single mistake, for all rounds of pairs

    /// <summary>All that is wrong: the wrong pixels of one picture, or how many of several are wrong.</summary>
    public double Wrong { get; } = pictures is [var only] ? only.WrongCount : pictures.Count(picture => !picture.IsRight);

    /// <summary>All trials that were compared closely, the best first.</summary>
    public List<WrongProgram> Run()
    {
        Unfinished[] unfinished = [.. Unfinished.Ways(pictures, done)];
        var mayBeOtherSample = MayBeOtherSample();
        var plain = Best([.. from way in unfinished from otherSample in (bool[])[false, true] select new WrongProgram(way, [], otherSample)]);
        Scene[] meshes = [.. pictures.Select(picture => picture.Scene).Where(scene => scene.Models.Any(model => model is Mesh))];
        var isSlow = Singles(Unfinished.Nothing, mayBeOtherSample ? [false, true] : [false])
            .ToLookup(trial => meshes.Any(scene => trial.Draw(scene).TrianglesTried > 0));
        var everySingle = Measured([.. isSlow[false]], Glance);
        var singles = Best(everySingle[..(everySingle.Count / 3)]);
        if (isSlow[true].Any() && !IsCertain(singles)) // tried only where no quick one explains the picture
        {
            everySingle = Sorted([.. everySingle, .. Measured([.. isSlow[true]], Glance)]);
            singles = Best(everySingle[..(everySingle.Count / 3)]);
        }
        if (!mayBeOtherSample)
        {
            var other = singles.Where(single => single.Id != center.Id).Take(OtherSamples).Select(single => single with { OtherSample = true });
            singles = Sorted([.. singles, .. Best([.. other])]);
        }
        if (!IsCertain(singles) && IsDone(singles, Rewordable)) singles = Sorted([.. singles, .. Best(Reworded(singles, Besides))]);
        var bare = singles;
        for (var (i, first) = (0, everySingle); i < Manners && !IsCertain(singles); i++)
            singles = Sorted([.. singles, .. first = Best(InManners([.. singles, .. first]), mannerRounds)]);
        singles = WithoutIdle(singles);
        // A missing shape counts for little beside a mistake that changes everything, so it is sought even if the mistake explains most.
        var beside = Best(
        [
            .. from single in bare.DistinctBy(single => single.Id).Take(Besides).Union(singles.DistinctBy(single => single.Id).Take(Besides))
               from way in unfinished
               where way.Kinds.Any() && single.Wordings.All(wording => MayShow(wording, way))
               select single with { Base = way },
        ]);
        List<WrongProgram> all = [.. plain, .. singles, .. beside];
        if (IsCertain([.. all.Where(trial => !trial.Base.Kinds.Any())]) || IsDone(all, Nearly)) return Sorted(all);
        var isDone = IsDone(all);
        if (isDone) all.AddRange(BestPairs(Pairs([.. Sorted(all).SelectMany(Written)], everySingle, 2)));
        if (isDone && !IsDone(plain)) return Sorted(all);

        // Few wrong pixels beside what is missing may be all that shows of a mistake.
        Unfinished[] ways = [.. Unfinished.ByColors(pictures, done).Take(Ways)];
        bool[] samples = plain is [{ OtherSample: true }, ..] ? [true] : [false];
        var onTop = Best([.. ways.SelectMany(way => Singles(way, samples))]);
        all.AddRange(onTop);
        if (isDone || IsDone(all)) return Sorted(all);

        foreach (var pairs in PairsByEffort(singles, everySingle, onTop))
        {
            var best = BestPairs(pairs);
            if (!IsCertain(best)) best = Sorted([.. best, .. Best(Reworded(best, Besides))]);
            for (var i = 0; i < Manners && !IsCertain(best); i++) best = Sorted([.. best, .. Best(InManners(best), mannerRounds)]);
            all.AddRange(best);
            if (IsCertain(all)) break;
        }
        return Sorted(all);
    }

    /// <summary>The ranked trials with some more, also with one of their mistakes in another wording; the best first.</summary>
    public List<WrongProgram> With(List<WrongProgram> trials, List<WrongProgram> ranked) =>
        Sorted([.. ranked, .. Measured(trials, 1), .. Best(Reworded(trials, trials.Count))]);

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

    /// <summary>Whether rays through the other place of each pixel explain so much alone that they are tried with every mistake.</summary>
    private bool MayBeOtherSample() => Measure(new(Unfinished.Nothing, [center], false), 0.05).Unexplained < 0.9 * Wrong;

    /// <summary>A trial, and before it the same with nothing missing: a shape may be misplaced by a second mistake, or clipping wrong.</summary>
    private static WrongProgram[] Written(WrongProgram trial) =>
        trial.Base.NotYet.Count > 0 ? [trial with { Base = Unfinished.Nothing }, trial] : [trial];

    /// <summary>A trial, and the same with rays through the scene's place of each pixel: a second mistake may move outlines otherwise.</summary>
    private static WrongProgram[] Resampled(WrongProgram trial) => trial.OtherSample ? [trial, trial with { OtherSample = false }] : [trial];

    private bool IsDone(List<WrongProgram> all, double left = Explained) => all.Exists(trial => trial.Misfit.Unexplained <= left * Wrong);

    /// <summary>Whether no second mistake could be worth its <see cref="WrongProgram.Cost"/>.</summary>
    private bool IsCertain(List<WrongProgram> all) => all.Exists(trial => trial.Misfit.Unexplained <= trial.LeastLeft(Wrong, rounding));

    // stable: of equals that with the usual wordings, and of these the first in the catalogue
    private List<WrongProgram> Sorted(List<WrongProgram> trials) =>
        [.. trials.OrderBy(trial => trial.Cost(Wrong, rounding) * Surprise(trial)).ThenBy(trial => trial.Unusual)];

    private double Surprise(WrongProgram trial) =>
        likely is null ? 1 : Math.Pow(Unlikely, trial.Wordings.Count(wording => !likely(wording)) + (trial.OtherSample && !likely(center) ? 1 : 0));

    private List<WrongProgram> Singles(Unfinished way, bool[] samples) =>
    [
        .. from mistake in known
           where MayShow(mistake, way)
           from wording in mistake.Wordings
           from otherSample in mistake == center ? (bool[])[false] : samples
           select new WrongProgram(way, [wording], otherSample),
    ];

    /// <summary>Whether the picture of a program that is unfinished in a way can show a mistake.</summary>
    private bool MayShow(Mistake mistake, Unfinished way) =>
        !way.AsMistakes.Contains(mistake) && mistake.Touches(kinds.Where(kind => !way.NotYet.Contains(kind)));

    /// <summary>Drops trials with rays through the other place of each pixel that explain no more than these rays alone.</summary>
    private static List<WrongProgram> WithoutIdle(List<WrongProgram> singles)
    {
        if (singles.Find(trial => trial.Id == center.Id) is not { } alone) return singles;
        return [.. singles.Where(trial => !trial.OtherSample || trial.Misfit.Unexplained < 0.9 * alone.Misfit.Unexplained)];
    }

    /// <summary>Pairs, cheapest first: the nearest mistakes with others, two in the formula of one shape, two that change whole pictures.</summary>
    private IEnumerable<List<WrongProgram>> PairsByEffort(List<WrongProgram> singles, List<WrongProgram> everySingle, List<WrongProgram> onTop)
    {
        yield return [.. Pairs(singles, everySingle, Partners), .. Pairs(onTop, [], UnfinishedPartners)];
        var shapes = Firsts(singles, everySingle, OtherSamples).Select(ChangedShapes).Distinct().Where(shape => BitOperations.IsPow2((int)shape));
        foreach (var shape in shapes) yield return AllPairs([.. everySingle.Where(single => ChangedShapes(single) == shape)]);
        // Of the camera's hundreds of wordings most draw what others do. Elsewhere two that draw all black may differ beside a second mistake.
        yield return AllPairs([.. everySingle.Where(IsOfAll).DistinctBy(single => single.Wordings[0] is { Concerns: Concerns.Camera } wording
            ? (wording.Id, single.Misfit) : (single.Wordings[0].Cause, default))]);
    }

    /// <summary>The shapes whose formulas a mistake changes; none if it changes whole pictures.</summary>
    private Concerns ChangedShapes(WrongProgram single) => IsOfAll(single) ? 0 : single.Draw(pictures[0].Scene).ChangedShapes;

    private static bool IsOfAll(WrongProgram single) => (single.Wordings[0].Concerns & Mistake.WholePicture) != 0;

    /// <summary>The nearest single mistakes, each with those others that explain most of what it leaves.</summary>
    private List<WrongProgram> Pairs(List<WrongProgram> singles, List<WrongProgram> everySingle, int partners) =>
    [
        .. from first in Firsts([.. singles.Where(trial => trial.Wordings.Count == 1)], everySingle, partners).SelectMany(Resampled).Distinct()
           let left = pictures.Select(picture => new Evidence(picture, first.Draw(picture.Scene))).ToArray()
           let seconds = Those(trial => left.Any(picture => picture.IsHelpedBy(trial.Draw(picture.Scene))),
               from other in known
               where other.Id != first.Wordings[0].Id && !(first.OtherSample && other == center)
               from wording in other.Wordings
               select (first with { Wordings = [first.Wordings[0], wording] }).InOneWay)
           from pair in Measured(Measured(seconds, Glance, left)[..Math.Min(60, seconds.Count)], 0.03, left).Take(Seconds)
           select pair,
    ];

    /// <summary>The nearest wording of each mistake, some that draw something else, and some that draw most colours right: with a second mistake,
    /// one of these may be right.</summary>
    private IEnumerable<WrongProgram> Firsts(List<WrongProgram> singles, List<WrongProgram> everySingle, int partners)
    {
        WrongProgram[] nearest = [.. singles.DistinctBy(trial => (trial.Id, trial.OtherSample)).Take(partners + 1)];
        if (everySingle.Count == 0) return nearest;
        nearestByColors ??= NearestByColors(everySingle);
        return nearest.Concat(Others(everySingle)).Concat(Others(nearestByColors)).DistinctBy(trial => (trial.Wordings[0], trial.OtherSample));

        IEnumerable<WrongProgram> Others(List<WrongProgram> trials) => trials.DistinctBy(trial => trial.Misfit)
            .Where(trial => Array.TrueForAll(nearest, other => other.Wordings[0] != trial.Wordings[0])).Take(partners / 2);
    }

    private List<WrongProgram> NearestByColors(List<WrongProgram> everySingle)
    {
        var byColors = pictures.Select(picture => picture.ByColors()).ToArray();
        return Measured(Measured(everySingle, Glance, byColors)[..(everySingle.Count / 8)], 0.05, byColors);
    }

    /// <summary>All pairs of some single mistakes, because neither of the two may be near alone.</summary>
    private List<WrongProgram> AllPairs(WrongProgram[] singles)
    {
        var pairs = Those(trial => pictures.Any(picture => !picture.IsRight && picture.MayBeExplainedBy(trial.Draw(picture.Scene))),
            from i in Enumerable.Range(0, singles.Length)
            from k in Enumerable.Range(0, i)
            where singles[i].Id != singles[k].Id
            select (singles[i] with { Wordings = [singles[k].Wordings[0], singles[i].Wordings[0]] }).InOneWay);
        return [.. Measured(pairs, Glance).Take(Closer)];
    }

    /// <summary>The trials that a few pixels do not rule out.</summary>
    private List<WrongProgram> Those(Func<WrongProgram, bool> may, IEnumerable<WrongProgram> trials) =>
        [.. trials.AsParallel().AsOrdered().WithDegreeOfParallelism(threads ?? Environment.ProcessorCount).Where(may)];

    /// <summary>The best trials with one of their mistakes in another wording; pairs also with rays through the other place of each pixel.</summary>
    private static List<WrongProgram> Reworded(List<WrongProgram> trials, int most) =>
    [
        .. from trial in trials.DistinctBy(trial => trial.Id).Take(most)
           from place in Enumerable.Range(0, trial.Wordings.Count)
           from wording in MistakeCatalog.Named(trial.Wordings[place].Id)!.Wordings
           from otherSample in trial.Wordings.Count > 1 ? (bool[])[false, true] : [trial.OtherSample]
           select trial.With(place, wording) with { OtherSample = otherSample },
    ];

    /// <summary>The best trials of each mistake, or pair, with one mistake in each of its manners.</summary>
    private static List<WrongProgram> InManners(List<WrongProgram> trials) =>
    [
        .. from same in trials.GroupBy(trial => trial.Id)
           from trial in same.DistinctBy(trial => (trial.Wordings[0], trial.Wordings[^1])).Take(Slips)
           from place in Enumerable.Range(0, trial.Wordings.Count)
           from wording in MistakeCatalog.Named(trial.Wordings[place].Id)!.InManners(trial.Wordings[place])
           select trial.With(place, wording),
    ];

    /// <summary>The same with more pixels in the first round, because a second mistake may explain only a few.</summary>
    private List<WrongProgram> BestPairs(List<WrongProgram> pairs) => Best(pairs, [(0.04, int.MaxValue), .. rounds[1..]]);

    /// <summary>Compares all trials, then the best ones more closely, and sorts these.</summary>
    private List<WrongProgram> Best(List<WrongProgram> trials, (double Share, int Trials)[]? otherRounds = null)
    {
        if (trials.Count > Many) trials = Measured(trials, Glance)[..(trials.Count / 4)];
        foreach (var (share, most) in otherRounds ?? rounds)
        {
            var kept = Math.Min(trials.Count, most == int.MaxValue ? most : Math.Max(most, share < 1 ? trials.Count / 8 : most));
            trials = Measured(trials[..kept], share);
        }
        return trials;
    }

    private List<WrongProgram> Measured(List<WrongProgram> trials, double share, IReadOnlyList<Evidence>? left = null)
    {
        var measured = new WrongProgram[trials.Count];
        Parallel.For(0, trials.Count, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount },
            i => measured[i] = trials[i] with { Misfit = Measure(trials[i], share, left) });
        return Sorted([.. measured]);
    }

    private Misfit Measure(WrongProgram trial, double share, IReadOnlyList<Evidence>? left = null)
    {
        var among = left ?? pictures;
        return among is [var only] ? only.Misfit(trial.Draw(only.Scene), share)
            : new(among.Sum(picture => picture.Loss(picture.Misfit(trial.Draw(picture.Scene), share))), 0);
    }
}
