using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>Finds the pairs of mistakes that are worth a close look: some hundreds of the millions that there are.</summary>
/// <param name="everySingle">Every single mistake of a finished program, the best first.</param>
/// <param name="inManners">Some of them in other manners.</param>
internal sealed class PairSearch(
    IReadOnlyList<Evidence> pictures, IReadOnlyList<Mistake> known, TrialRanking ranking,
    List<WrongProgram> everySingle, List<WrongProgram> inManners)
{
    /// <summary>How many single mistakes are tried together with every other: of a finished program at first, at last if there is one picture only,
    /// and of an unfinished one.</summary>
    private const int Partners = 10, MorePartners = 20, UnfinishedPartners = 4;

    /// <summary>For how many of the nearest mistakes the formula that they change is taken to have a second one.</summary>
    private const int Formulas = 6;

    /// <summary>How many second mistakes of each first one are compared closely, besides those that are as near as the nearest, and how many of all
    /// pairs.</summary>
    private const int Seconds = 8, Closer = 100;

    /// <summary>How many wordings of each mistake are tried with all others: its usual one, and the nearest.</summary>
    private const int MostAlike = 24;

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
        // Of the camera's hundreds of wordings most draw what others do. Elsewhere two that draw all black may differ beside a second mistake.
        var others = everySingle.Where(IsOfAll).DistinctBy(single => single.Wordings[0] is { Concerns: Concerns.Camera } wording
            ? (wording.Id, single.Misfit) : (single.Wordings[0].Cause, default));
        yield return AllPairs([.. others.GroupBy(single => single.Id).SelectMany(same => same.OrderBy(single => single.Unusual).Take(MostAlike))]);
        if (pictures.Count == 1) yield return Of(Firsts(singles, MorePartners).Except(firsts));
    }

    /// <summary>The shapes whose formulas a mistake changes; none if it changes whole pictures.</summary>
    private Concerns ChangedShapes(WrongProgram single) => IsOfAll(single) ? 0 : single.Draw(pictures[0].Scene).ChangedShapes;

    private static bool IsOfAll(WrongProgram single) => (single.Wordings[0].Concerns & Mistake.WholePicture) != 0;

    /// <summary>The nearest mistakes, each with those others that explain most of what it leaves.</summary>
    public List<WrongProgram> WithNearest(List<WrongProgram> singles, int partners) => Of(Firsts(singles, partners));

    /// <summary>Single mistakes, each with those others that explain most of what it leaves.</summary>
    private List<WrongProgram> Of(IEnumerable<WrongProgram> firsts) =>
    [
        .. from first in firsts.SelectMany(Resampled).Distinct()
           let left = pictures.Select(picture => new Evidence(picture, first.Draw(picture.Scene))).ToArray()
           let seconds = ranking.Those(trial => left.Any(picture => picture.IsHelpedBy(trial.Draw(picture.Scene))),
               from other in known
               where other.Id != first.Wordings[0].Id && !(first.OtherSample && other == WrongProgram.Center)
               from wording in other.Wordings
               select (first with { Wordings = [first.Wordings[0], wording] }).InOneWay)
           let glanced = ranking.Measured(seconds, TrialRanking.Glance, left)
           let nearest = ranking.Measured(glanced[..Math.Min(60, glanced.Count)], 0.03, left)
           from pair in nearest.Where((pair, i) => i < Seconds || pair.Misfit.Unexplained == nearest[0].Misfit.Unexplained)
           select pair,
    ];

    /// <summary>The nearest wording of each mistake.</summary>
    private static WrongProgram[] Nearest(List<WrongProgram> singles, int partners) =>
        [.. singles.Where(trial => trial.Wordings.Count == 1).DistinctBy(trial => (trial.Id, trial.OtherSample)).Take(partners + 1)];

    /// <summary>The nearest wording of each mistake, some that draw something else, and some that draw most colours right: with a second mistake,
    /// one of these may be right.</summary>
    private IEnumerable<WrongProgram> Firsts(List<WrongProgram> singles, int partners)
    {
        var nearest = Nearest(singles, partners);
        nearestByColors ??= NearestByColors();
        return nearest.Concat(Others(everySingle)).Concat(Others(nearestByColors)).DistinctBy(trial => (trial.Wordings[0], trial.OtherSample));

        IEnumerable<WrongProgram> Others(List<WrongProgram> trials) => trials.DistinctBy(trial => trial.Misfit)
            .Where(trial => Array.TrueForAll(nearest, other => other.Wordings[0] != trial.Wordings[0])).Take(partners / 2);
    }

    private List<WrongProgram> NearestByColors()
    {
        var byColors = pictures.Select(picture => picture.ByColors()).ToArray();
        var glanced = ranking.Measured([.. everySingle, .. inManners], TrialRanking.Glance, byColors);
        return ranking.Measured(glanced[..(everySingle.Count / 8)], 0.05, byColors);
    }

    /// <summary>All pairs of some single mistakes, because neither of the two may be near alone.</summary>
    private List<WrongProgram> AllPairs(WrongProgram[] singles)
    {
        var pairs = ranking.Those(trial => pictures.Any(picture => !picture.IsRight && picture.MayBeExplainedBy(trial.Draw(picture.Scene))),
            from i in Enumerable.Range(0, singles.Length)
            from k in Enumerable.Range(0, i)
            where singles[i].Id != singles[k].Id
            select (singles[i] with { Wordings = [singles[k].Wordings[0], singles[i].Wordings[0]] }).InOneWay);
        return [.. ranking.Measured(pairs, TrialRanking.Glance).Take(Closer)];
    }

    /// <summary>A trial, and the same with rays through the scene's place of each pixel: a second mistake may move outlines otherwise.</summary>
    private static WrongProgram[] Resampled(WrongProgram trial) => trial.OtherSample ? [trial, trial with { OtherSample = false }] : [trial];
}
