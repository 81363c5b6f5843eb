using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>Finds the pairs of mistakes that are worth a close look: some hundreds of the millions that there are.</summary>
/// <param name="everySingle">Every single mistake of a finished program, the best first.</param>
internal sealed class PairSearch(
    IReadOnlyList<Evidence> pictures, IReadOnlyList<Mistake> known, CandidateRanking ranking,
    List<WrongProgram> everySingle)
{
    /// <summary>How many single mistakes are tried together with every other: of a finished program at first, at last if there is one picture only,
    /// and of an unfinished one.</summary>
    public const int Partners = 10;

    /// <inheritdoc cref="Partners"/>
    private const int MorePartners = 20, UnfinishedPartners = 4;

    /// <summary>For how many of the nearest mistakes the formula that they change is taken to have a second one.</summary>
    private const int Formulas = 6;

    /// <summary>How many second mistakes of each first one are compared closely, besides those that are as near as the nearest, and how many of all
    /// pairs.</summary>
    private const int Seconds = 8, Closer = 100;

    /// <summary>How many variants of each mistake are tried with all others: its usual one, and the nearest.</summary>
    private const int MaxAlike = 24;

    private readonly Dictionary<(Unfinished, Mistake, bool), List<WrongProgram>> found = []; // by the first mistake, for all rounds of pairs

    private List<WrongProgram>? nearestByColors; // of every single mistake, for all rounds of pairs

    /// <summary>Pairs, cheapest first: the nearest mistakes with others, two in the formula of one shape, two that change whole pictures.</summary>
    /// <param name="singles">The nearest mistakes of a finished program.</param>
    /// <param name="onTop">Those of unfinished ones.</param>
    public IEnumerable<List<WrongProgram>> ByEffort(List<WrongProgram> singles, List<WrongProgram> onTop)
    {
        WrongProgram[] firsts = [.. Firsts(singles, Partners)];
        yield return [.. Of(firsts), .. Of(Nearest(onTop, UnfinishedPartners))];
        var shapes = Firsts(singles, Formulas).Select(ChangedShapes).Distinct().Where(shape => BitOperations.IsPow2((int)shape));
        foreach (var shape in shapes) yield return AllPairs([.. everySingle.Where(single => ChangedShapes(single) == shape)]);
        // Of the camera's hundreds of variants most draw what others do. Elsewhere two that draw all black may differ beside a second mistake.
        var others = everySingle.Where(IsOfAll).DistinctBy(single => single.Variants[0] is { Affects: Affects.Camera } variant
            ? (variant.Id, single.Misfit) : (single.Variants[0].Cause, default));
        yield return AllPairs([.. others.GroupBy(single => single.Id).SelectMany(same => same.OrderBy(single => single.Unusual).Take(MaxAlike))]);
        if (pictures.Count == 1) yield return Of(Firsts(singles, MorePartners).Except(firsts));
    }

    /// <summary>The shapes whose formulas a mistake changes; none if it changes whole pictures.</summary>
    private Affects ChangedShapes(WrongProgram single) => IsOfAll(single) ? 0 : single.For(pictures[0].Scene)?.ChangedShapes ?? 0;

    private static bool IsOfAll(WrongProgram single) => (single.Variants[0].Affects & Mistake.WholePicture) != 0;

    /// <summary>The nearest mistakes, each with those others that explain most of what it leaves.</summary>
    public List<WrongProgram> WithNearest(List<WrongProgram> singles, int partners) => Of(Firsts(singles, partners));

    /// <summary>Single mistakes, each with those others that explain most of what it leaves.</summary>
    private List<WrongProgram> Of(IEnumerable<WrongProgram> firsts)
    {
        var all = new List<WrongProgram>();
        foreach (var first in firsts.SelectMany(Resampled).Distinct())
        {
            var key = (first.Base, first.Variants[0], first.OtherSample);
            if (!found.TryGetValue(key, out var pairs)) found[key] = pairs = WithSeconds(first);
            all.AddRange(pairs);
        }
        return all;
    }

    private List<WrongProgram> WithSeconds(WrongProgram first)
    {
        var left = pictures.Select(picture => first.For(picture.Scene) is { } program ? new Evidence(picture, program) : null).OfType<Evidence>()
            .ToArray();
        if (left.Length < pictures.Count) return [];
        var seconds = ranking.Plausible(candidate => left.Any(picture => picture.IsImprovedBy(candidate.For(picture.Scene))),
            from other in known
            where other.Id != first.Variants[0].Id && !(first.OtherSample && other == WrongProgram.Center)
            from variant in other.Variants
            select (first with { Variants = [first.Variants[0], variant] }).Canonical);
        var screened = ranking.Measured(seconds, CandidateRanking.Screening, left);
        var nearest = ranking.Measured(screened[..Math.Min(60, screened.Count)], 0.03, left);
        return [.. nearest.Where((pair, i) => i < Seconds || pair.Misfit.Unexplained == nearest[0].Misfit.Unexplained)];
    }

    /// <summary>The nearest variant of each mistake.</summary>
    private static WrongProgram[] Nearest(List<WrongProgram> singles, int partners) =>
    [
        .. singles.Where(candidate => candidate.Variants.Count == 1).DistinctBy(candidate => (candidate.Id, candidate.OtherSample))
            .Take(partners + 1),
    ];

    /// <summary>The nearest variant of each mistake, some that draw something else, and some that draw most colours right: with a second mistake,
    /// one of these may be right.</summary>
    private IEnumerable<WrongProgram> Firsts(List<WrongProgram> singles, int partners)
    {
        var nearest = Nearest(singles, partners);
        nearestByColors ??= NearestByColors();
        return nearest.Concat(Others(everySingle)).Concat(Others(nearestByColors))
            .DistinctBy(candidate => (candidate.Variants[0], candidate.OtherSample));

        IEnumerable<WrongProgram> Others(List<WrongProgram> candidates) => candidates.DistinctBy(candidate => candidate.Misfit)
            .Where(candidate => Array.TrueForAll(nearest, other => other.Variants[0] != candidate.Variants[0])).Take(partners / 2);
    }

    private List<WrongProgram> NearestByColors()
    {
        var byColors = pictures.Select(picture => picture.ByColors()).ToArray();
        var screened = ranking.Measured(everySingle, CandidateRanking.Screening, byColors);
        return ranking.Measured(screened[..(everySingle.Count / 8)], 0.05, byColors);
    }

    /// <summary>All pairs of some single mistakes, because neither of the two may be near alone.</summary>
    private List<WrongProgram> AllPairs(WrongProgram[] singles)
    {
        var pairs = ranking.Plausible(
            candidate => pictures.Any(picture => !picture.IsRight && picture.MayBeExplainedBy(candidate.For(picture.Scene))),
            from i in Enumerable.Range(0, singles.Length)
            from k in Enumerable.Range(0, i)
            where singles[i].Id != singles[k].Id
            select (singles[i] with { Variants = [singles[k].Variants[0], singles[i].Variants[0]] }).Canonical);
        return [.. ranking.Measured(pairs, CandidateRanking.Screening).Take(Closer)];
    }

    /// <summary>A candidate, and the same with rays through the scene's own sample points: a second mistake may move outlines otherwise.</summary>
    private static WrongProgram[] Resampled(WrongProgram candidate) =>
        candidate.OtherSample ? [candidate, candidate with { OtherSample = false }] : [candidate];
}
