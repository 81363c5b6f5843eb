namespace RayCaster.Teaching;

/// <summary>The result for a picture; see the members of <see cref="Diagnosis"/>.</summary>
internal sealed record Answer(Finding Finding)
{
    public IReadOnlyList<string> NotYet { get; init; } = [];

    public IReadOnlyList<string> Likely { get; init; } = [];

    public IReadOnlyList<Suspect> Suspects { get; init; } = [];

    public IReadOnlyList<Suspect> Nearest { get; init; } = [];
}

/// <summary>Decides which of the candidates that a search has compared are named, and which sentences the answer has if none is.</summary>
/// <param name="done">What the program certainly draws.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
/// <param name="byModels">The picture, model by model; null if it has another size.</param>
/// <param name="leftByMissingModel">What is left unexplained if one model is missing; null if no missing model explains the picture.</param>
internal sealed class Judgement(
    SceneDiagnosis prepared, Evidence evidence, IReadOnlyCollection<string> done, Predicate<Mistake>? likely,
    SceneDifference? byModels, double? leftByMissingModel)
{
    /// <summary>A certain cause leaves at most this share of the wrong pixels unexplained.</summary>
    public const double Explained = 0.05;

    /// <summary>A mistake that leaves a greater share of the wrong pixels fits only by chance; several mistakes may leave less, but more if they
    /// leave at most a third of what one leaves. A mistake whose pixels may lie anywhere leaves more.</summary>
    public const double MaxLeft = 0.1;

    private const double MaxLeftByPair = 0.05, MaxLeftByBetterPair = 0.08, Third = 1 / 3.0, MaxLeftIfScattered = 0.18;

    /// <summary>If an unfinished program leaves at most this share of the wrong pixels, the rest is right; more with rays through the other sample
    /// point of each pixel. If a mistake leaves more than the first share, other numbers of the scene are tried.</summary>
    private const double Nearly = 0.001, NearlyOtherSample = 0.01;

    /// <summary>Another number of the scene is named in place of one mistake, or of two, if it leaves less than this share of what they leave.
    /// </summary>
    private const double NumberForOne = 0.25, NumberForPair = 0.8;

    /// <summary>Mistakes are named in place of missing shapes or a missing model if they leave at most this share of what these leave.</summary>
    private const double Much = 0.25;

    /// <summary>A mistake is mentioned at all if it leaves at most this share of the wrong pixels; two mistakes may leave less.</summary>
    private const double Mentioned = 0.8, MentionedPair = 0.4;

    /// <summary>How many of the nearest mistakes are mentioned if none explains the picture.</summary>
    private const int Shown = 3;

    /// <summary>How many of the best are examined, and how many of them are named.</summary>
    private const int Examined = 12, MaxNamed = 5;

    private readonly SuspectFinder suspects = new(prepared, evidence);

    private readonly int wrong = evidence.WrongCount;

    private double leftByOne;

    /// <summary>Searches, and decides.</summary>
    public Answer Decide()
    {
        var search = new DiagnosisSearch([evidence], prepared.Known, done, prepared.Threads, likely, prepared.Budget, prepared.Possible);
        var ranked = search.Run();
        leftByOne = ranked.Where(IsOne).Select(candidate => candidate.Misfit.Unexplained).DefaultIfEmpty(0).Min();
        var best = search.Ranking.WithoutIdle(Best(ranked));
        var isEnough = IsEnough(best);
        var (sentences, isBetter) = OtherCause(best, isEnough);
        if (isEnough && !isBetter) return Naming(best, ranked, search.Ranking, sentences);

        if (evidence.IsOnlyOutlines) return new(Finding.Matches);
        if (leftByMissingModel is not null) return new(Finding.NoneOfThese);
        if (sentences.Count == 0 && LikelyCause.OfTheWhole(evidence) is { } whole) sentences = [whole];
        return new(Finding.NoneOfThese) { Likely = sentences, Nearest = isBetter ? [] : NearestOf(ranked, best) };
    }

    private WrongProgram Best(List<WrongProgram> ranked)
    {
        var best = ranked.Find(candidate => candidate.Misfit.Unexplained <= MayLeave(candidate)) ?? ranked[0];
        if (!best.Base.Kinds.Any() || best.Misfit.Unexplained <= Nearly * wrong) return best;
        // few wrong pixels may be all that shows of a misplaced shape
        return ranked.Find(candidate => !candidate.Base.Kinds.Any() && candidate.Misfit.Unexplained <= Much * best.Misfit.Unexplained) ?? best;
    }

    /// <summary>Whether a candidate explains the picture. Where one missing model is enough, two mistakes are not assumed.</summary>
    private bool IsEnough(WrongProgram best)
    {
        var left = best.Misfit.Unexplained;
        return leftByMissingModel is not { } byModel ? left <= Math.Max(Explained * wrong, MayLeave(best))
            : left <= Explained * wrong && (best.Variants.Count < 2 || left < Much * byModel);
    }

    /// <summary>What a candidate may leave unexplained, in pixels.</summary>
    private double MayLeave(WrongProgram candidate) => wrong * (candidate.Variants is [{ Id: "tri-area" }] ? MaxLeftIfScattered
        : IsOne(candidate) ? MaxLeft : candidate.Misfit.Unexplained <= Third * leftByOne ? MaxLeftByBetterPair : MaxLeftByPair);

    private static bool IsOne(WrongProgram candidate) => candidate.Variants.Count + candidate.Base.Kinds.Count() < 2;

    /// <summary>The sentences about another cause, and whether it explains the picture better than the best candidate.</summary>
    private (IReadOnlyList<string> Sentences, bool IsBetter) OtherCause(WrongProgram best, bool isEnough)
    {
        // Two mistakes of the camera may make the picture of another angle of view, or by chance nearly so: the more exact of both is named.
        var isOfCamera = best.Named.Count > 1 && best.Named.All(mistake => mistake.Affects == Affects.Camera);
        if ((best.Misfit.Unexplained <= Nearly * wrong && !isOfCamera) || leftByMissingModel is not null || evidence.IsOnlyOutlines
            || byModels is null) return ([], false);
        var most = best.Misfit * (best.Named.Count < 2 ? NumberForOne : isOfCamera ? 1 : NumberForPair);
        var (misfit, certain) = LikelyCause.Certain(prepared, byModels, evidence);
        if (certain is not null && misfit.CompareTo(most) < 0) return ([certain], true);
        if (!isEnough) return ([.. LikelyCause.Hints(byModels, evidence)], false);
        return (certain is not null && misfit.Unexplained <= CandidateRanking.Idle * wrong ? [certain] : [], false);
    }

    private IReadOnlyList<Suspect> NearestOf(List<WrongProgram> ranked, WrongProgram best)
    {
        var likeliest = best.For(prepared.Scene) ?? FormulaProgram.For(prepared.Scene.Camera);
        return
        [
            .. ranked.Where(candidate => candidate.Variants.Count > 0
                    && candidate.Misfit.Unexplained < (candidate.Variants.Count > 1 ? MentionedPair : Mentioned) * wrong)
                .DistinctBy(candidate => IdsOf(candidate.Variants)).Take(Shown)
                .OrderBy(candidate => candidate.Misfit.Unexplained).Select(candidate => suspects.Of(candidate, likeliest)),
        ];
    }

    /// <summary>Names the best candidate, and others that also explain the picture.</summary>
    private Answer Naming(WrongProgram best, List<WrongProgram> ranked, CandidateRanking ranking, IReadOnlyList<string> sentences)
    {
        string[] missing = [.. best.Base.Kinds];
        if (best.Variants.Count == 0 && missing.Length > 0
            && best.Misfit.Unexplained > (best.OtherSample ? NearlyOtherSample : Nearly) * wrong)
        {
            // Beside missing shapes a small mistake counts for little, so the rest is judged by itself.
            var drawn = new Unfinished(missing).PartOf(prepared.Scene);
            var rest = new SceneDiagnosis(drawn, prepared.Threads, prepared.Possible, prepared.Budget).Judge(evidence.Picture, done, likely);
            if (rest.Finding != Finding.Matches)
                return new(rest.Finding) { NotYet = [.. missing, .. rest.NotYet], Suspects = rest.Suspects, Likely = rest.Likely };
        }
        var named = ranked.Where(candidate => candidate.Named.Count > 0 && candidate.Misfit.Unexplained <= MayLeave(candidate))
            .DistinctBy(candidate => candidate.Id).Take(Examined).Select(ranking.WithoutIdle).Prepend(best)
            .Where(candidate => candidate.Named.Count > 0);
        if (best.Named.Count == 0) // what may have lost those shapes, if they are written already
            named = named.Where(candidate =>
                candidate.Base.NotYet.Count == 0 && candidate.Misfit.Unexplained <= best.Misfit.Unexplained + 0.005 * wrong);
        else if (missing.Length > 0) named = named.Take(1);
        if (missing.Length > 0 && prepared.Budget?.IsSpent() != true) named = named.Concat(suspects.HidingMistakes(best));
        WrongProgram[] first = [.. named.DistinctBy(candidate => IdsOf(candidate.Named)).Take(MaxNamed)];
        var likeliest = first is [var top, ..] ? top.For(prepared.Scene) : null;
        return new(best.Named.Count > 0 ? Finding.Mistake : Finding.Unfinished)
        {
            NotYet = best.Base.NotYet,
            Likely = sentences,
            Suspects =
            [
                .. first.Take(1).Concat(first.Skip(1).OrderBy(candidate => candidate.Misfit.Unexplained))
                    .Select(candidate => suspects.Of(candidate, likeliest!))
                    .DistinctBy(suspect => IdsOf(suspect.Mistakes)),
            ],
        };
    }

    /// <summary>The same for mistakes in another order, or in other variants.</summary>
    private static string IdsOf(IEnumerable<Mistake> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());
}
