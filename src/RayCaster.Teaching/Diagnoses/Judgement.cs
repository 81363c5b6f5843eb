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
    SceneDifference? byModels, Misfit? leftByMissingModel)
{
    /// <summary>What explains a picture leaves at most this share of the wrong pixels.</summary>
    public const double Explained = 0.1;

    /// <summary>What explanations cost that are mentioned where none is named, for each picture.</summary>
    public const double Mentioned = 1.5 * Priors.OtherProgram;

    /// <summary>How many of the nearest mistakes are mentioned if none explains the picture.</summary>
    private const int Shown = 3;

    /// <summary>How many of the best are examined, and how many of them are named.</summary>
    private const int Examined = 12, MaxNamed = 5;

    private readonly SuspectFinder suspects = new(prepared, evidence);

    /// <summary>Searches, and decides: named is what is shorter than any other explanation.</summary>
    public Answer Decide()
    {
        var ranked = new ExplanationSearch([evidence], prepared.Known, done, prepared.Threads, likely, prepared.Budget, prepared.Possible).Run();
        var best = ranked[0];
        var byMissingModel = leftByMissingModel is { } left ? Priors.MissingModel + evidence.BitsOf(left) : double.PositiveInfinity;
        var isEnough = best.Total < Math.Min(Priors.OtherProgram, byMissingModel);
        var (sentences, byNumber) = OtherCause(best, isEnough);
        if (isEnough && best.Total <= byNumber) return Naming(best, ranked, sentences);

        if (evidence.IsOnlyOutlines) return new(Finding.Matches);
        if (leftByMissingModel is not null) return new(Finding.NoneOfThese);
        if (sentences.Count == 0 && LikelyCause.OfTheWhole(evidence) is { } whole) sentences = [whole];
        return new(Finding.NoneOfThese) { Likely = sentences, Nearest = byNumber < best.Total ? [] : NearestOf(ranked, best) };
    }

    /// <summary>The sentences about another cause, and the bits of its explanation of the picture.</summary>
    private (IReadOnlyList<string> Sentences, double Total) OtherCause(WrongProgram best, bool isEnough)
    {
        var isOfCamera = best.Named.Count > 1 && best.Named.All(mistake => mistake.Affects == Affects.Camera);
        var price = isOfCamera ? Priors.NumberForTwo : Priors.OtherNumber;
        if (best.Total <= price || leftByMissingModel is not null || evidence.IsOnlyOutlines || byModels is null)
            return ([], double.PositiveInfinity);
        var (misfit, certain) = LikelyCause.Certain(prepared, byModels, evidence);
        var total = certain is null ? double.PositiveInfinity : price + evidence.BitsOf(misfit);
        if (total < best.Total) return ([certain!], total);
        return (isEnough ? [] : [.. LikelyCause.Hints(byModels, evidence)], double.PositiveInfinity);
    }

    private IReadOnlyList<Suspect> NearestOf(List<WrongProgram> ranked, WrongProgram best)
    {
        return
        [
            .. ranked.Where(candidate => candidate.Variants.Count > 0 && candidate.Total < Mentioned)
                .DistinctBy(candidate => IdsOf(candidate.Variants)).Take(Shown)
                .OrderBy(candidate => candidate.Misfit.Unexplained).Select(candidate => suspects.Of(candidate, best)),
        ];
    }

    /// <summary>Names the best candidate, and others that also explain the picture.</summary>
    private Answer Naming(WrongProgram best, List<WrongProgram> ranked, IReadOnlyList<string> sentences)
    {
        string[] missing = [.. best.Base.Kinds];
        if (best.Variants.Count == 0 && missing.Length > 0 && evidence.BitsOf(best.Misfit) > Priors.NotYet)
        {
            // Beside missing shapes a small mistake counts for little, so the rest is judged by itself.
            var drawn = new Unfinished(missing).PartOf(prepared.Scene);
            var rest = new SceneDiagnosis(drawn, prepared.Threads, prepared.Possible, prepared.Budget).Judge(evidence.Picture, done, likely);
            if (rest.Finding != Finding.Matches)
                return new(rest.Finding) { NotYet = [.. missing, .. rest.NotYet], Suspects = rest.Suspects, Likely = rest.Likely };
        }
        var named = ranked.Where(candidate => candidate.Named.Count > 0 && candidate.Total < Priors.OtherProgram)
            .DistinctBy(candidate => candidate.Id).Take(Examined);
        if (best.Named.Count == 0) // what may have lost those shapes, if they are written already
            named = named.Where(candidate => candidate.Base.NotYet.Count == 0 && candidate.Total < best.Total + Priors.Known);
        else if (missing.Length > 0) named = named.Take(1);
        if (missing.Length > 0 && prepared.Budget?.IsSpent() != true) named = named.Concat(suspects.HidingMistakes(best));
        WrongProgram[] first = [.. named.DistinctBy(candidate => IdsOf(candidate.Named)).Take(MaxNamed)];
        return new(best.Named.Count > 0 ? Finding.Mistake : Finding.Unfinished)
        {
            NotYet = best.Base.NotYet,
            Likely = sentences,
            Suspects =
            [
                .. first.Select(candidate => suspects.Of(candidate, first[0])).DistinctBy(suspect => IdsOf(suspect.Mistakes)),
            ],
        };
    }

    /// <summary>The same for mistakes in another order, or in other variants.</summary>
    private static string IdsOf(IEnumerable<Mistake> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());
}
