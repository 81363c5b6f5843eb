namespace RayCaster.Teaching.Diagnosis;

/// <summary>Tells what is wrong with one picture: the mistakes that are named, or the sentences if none is.</summary>
internal sealed class PictureDiagnosis(Diagnoser prepared, PictureSample sample, SearchOptions options)
{
    /// <summary>How many of the nearest mistakes are mentioned if none explains the picture.</summary>
    private const int Shown = 3;

    /// <summary>The share of what is drawn wrong that such a mistake explains, at least; of two, the share that each explains of all.</summary>
    private const double LeastExplained = 0.05;

    /// <summary>How many of the best are examined, and how many of them are named.</summary>
    private const int Examined = 12, MaxNamed = 5;

    private Observations Observed => field ??= sample.Observe(options.Threads);

    private Decision Decision => field ??= new([sample], [0], [Observed], options);

    private SuspectFinder Suspects => new(prepared, sample);

    /// <summary>What is known before a mistake is tried.</summary>
    public DiagnosisResult Facts => new()
    {
        TooManyModels = prepared.TooManyModels,
        ProvesNothing = prepared.Right.IsNearlyOneColor,
        Rounding = sample.Difference is { } difference && difference.OffByOne > PictureJudge.Rounded * difference.Pixels
            ? ComparisonText.RoundedOtherwise(difference) : null,
        PixelCount = sample.PixelCount,
        WrongCount = sample.WrongCount,
        OutlineCount = sample.OutlineCount,
    };

    /// <summary>The result of a picture that is wrong, or nearly.</summary>
    public DiagnosisResult Find()
    {
        if (sample.WrongCount == 0 || (prepared.TooManyModels && sample.IsOnlyOutlines)) return Facts with { Kind = DiagnosisKind.Matches };
        if (Decision.TellsNothing) return Facts with { Kind = DiagnosisKind.TellsNothing, Likely = [Observed.Plain!] };
        if (prepared.TooManyModels) return FromObserved();
        var best = Decision.Best;
        if (best.Total < Priors.LeastWithoutFormulas) return Naming();
        var (sentence, byNumber) = Observed.Best is null ? OtherNumberFor(best) : default;
        if (sentence is not null && byNumber < Math.Min(best.Total, Decision.Without))
            return Facts with { Kind = DiagnosisKind.NoneOfThese, Likely = [sentence], IsOfScene = true };
        if (Decision.IsNamed) return Naming();
        if (sample.IsOnlyOutlines) return Facts with { Kind = DiagnosisKind.Matches };
        var none = FromObserved();
        return Observed.Best is not null ? none : none with { Nearest = NearestOf(Observed.ByModels?.FaultLocalization), IsOpen = true };
    }

    /// <summary>What is said if no formula explains the picture.</summary>
    private DiagnosisResult FromObserved() => Facts with
    {
        Kind = Observed.Best?.Way == Way.Places ? DiagnosisKind.NotTheFormulas : DiagnosisKind.NoneOfThese,
        Likely = Observed.Sentences,
        MissingModel = Observed.MissingModels,
        IsOfScene = Observed.IsOfScene,
    };

    /// <summary>What is said if another number of the scene explains the picture, and its bits; null if none does.</summary>
    private (string? Sentence, double Total) OtherNumberFor(Hypothesis best)
    {
        var isOfCamera = best.Reported.Count > 1 && best.Reported.All(mistake => mistake.Steps.All(step => step.IsOfRays()));
        var price = isOfCamera ? Priors.NumberForTwo : Priors.NumberOfScene;
        if (best.Total <= price || sample.IsOnlyOutlines || Observed.ByModels is not { } byModels) return default;
        var (residual, sentence) = GivenNumber.Find(prepared.Scene, byModels, sample, prepared.Threads);
        return residual.Unexplained <= Decision.Explained * sample.WrongCount ? (sentence, price + sample.BitsOf(residual)) : default;
    }

    /// <summary>The known mistakes that explain a part of what is drawn wrong; one of thousands of slips would, by chance.</summary>
    private IReadOnlyList<Suspect> NearestOf(FaultLocalization? wrong)
    {
        var background = prepared.Scene.Background.ToBytes();
        return
        [
            .. Decision.Ranked.Where(candidate => candidate.Mistakes.Count > 0 && candidate.Mistakes.All(mistake => mistake.Mutation is null)
                    && Decision.IsMentioned(candidate) && IsOfTheseKinds(candidate)
                    && sample.ShareExplained(candidate.Program, IsDrawnWrong) >= LeastExplained && candidate.Changes.All(IsNeeded(candidate)))
                .DistinctBy(candidate => IdsOf(candidate.Mistakes)).Take(Shown)
                .OrderBy(candidate => candidate.Residual.Unexplained).Select(candidate => Suspects.Examine(candidate, Decision.Best)),
        ];

        bool IsOfTheseKinds(Hypothesis candidate) => wrong is null or { Kinds.Count: 0, Agreeing.Count: 0 } || candidate.Mistakes.All(mistake =>
            wrong.Kinds.Count > 0 ? mistake.Steps.Any(step => wrong.Kinds.Any(kind => ShapeKind.Find(kind)?.Step == step))
                : !mistake.Steps.All(step => step.IsOfRays()));

        bool IsDrawnWrong((byte, byte, byte) shown) => wrong is { Kinds.Count: > 0 } ? wrong.ShowsColor(shown)
            : shown != background && shown != default;

        Func<Change, bool> IsNeeded(Hypothesis candidate) => change => candidate.Changes.Length == 1
            || Hypothesis.Create(candidate.Changes.Remove(change)) is not { } less
            || sample.Residual(less.Program).Unexplained > candidate.Residual.Unexplained + LeastExplained * sample.WrongCount;
    }

    /// <summary>Names the best candidate, and others that also explain the picture.</summary>
    private DiagnosisResult Naming()
    {
        var best = Decision.Best;
        string[] missing = [.. best.MissingShapes];
        if (best.Mistakes.Count == 0 && missing.Length > 0 && sample.BitsOf(best.Residual) > Priors.MissingPart)
        {
            // Beside missing shapes a small mistake counts for little, so the rest is judged by itself.
            var drawn = prepared.Scene with { Models = [.. prepared.Scene.Models.Where(model => !missing.Contains(model.Kind))] };
            var rest = new Diagnoser(drawn, prepared.Threads, prepared.Possible, prepared.Budget)
                .Diagnose(sample.Picture, options.Done, options.Likely);
            if (rest.Kind != DiagnosisKind.Matches)
                return Facts with
                {
                    Kind = rest.Kind,
                    MissingParts = [.. missing, .. rest.MissingParts],
                    Suspects = rest.Suspects,
                    Likely = rest.Likely,
                    IsOfScene = rest.IsOfScene,
                    IsOpen = rest.IsOpen,
                };
        }
        var named = Decision.Ranked.Where(candidate => candidate.Reported.Count > 0 && candidate.Total < Priors.OtherProgram)
            .DistinctBy(candidate => candidate.Key).Take(Examined);
        if (best.Reported.Count == 0) // what may have lost those shapes, if they are written already
            named = named.Where(candidate => candidate.MissingParts.Count == 0 && candidate.Total < best.Total + Priors.Known);
        else if (missing.Length > 0) named = named.Take(1);
        if (missing.Length > 0 && prepared.Budget?.IsSpent() != true) named = named.Concat(Suspects.HidingMistakes(best));
        Hypothesis[] first = [.. named.DistinctBy(candidate => IdsOf(candidate.Reported)).Take(MaxNamed)];
        Suspect[] suspects = [.. first.Select(candidate => Suspects.Examine(candidate, first[0])).DistinctBy(suspect => IdsOf(suspect.Mistakes))];
        return Facts with
        {
            Kind = best.Reported.Count > 0 ? DiagnosisKind.Mistake : best.MissingParts.Count > 0 ? DiagnosisKind.Unfinished
                : DiagnosisKind.NotTheFormulas,
            MissingParts = best.MissingParts,
            Likely = best.Unreached is { } lines ? [lines] : [],
            Suspects = suspects is [{ Twins: var twins }, ..] // no mistake is told twice
                ? [.. suspects.Where((suspect, i) => i == 0 || suspect.Mistakes is not [var one] || twins.All(twin => twin.Id != one.Id))] : [],
            IsOpen = best.Reported.Count > 0 && best.Residual.Unexplained >= 0.5,
        };
    }

    /// <summary>The same for mistakes in another order, or made in other ways.</summary>
    private static string IdsOf(IEnumerable<Change> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());
}
