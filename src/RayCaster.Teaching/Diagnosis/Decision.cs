namespace RayCaster.Teaching.Diagnosis;

/// <summary>Decides which of the hypotheses that a search has found are named, and which sentences the diagnosis has if none is.</summary>
/// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
/// <param name="done">What the program certainly draws.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
internal sealed class Decision(Diagnoser prepared, Picture picture, IReadOnlyCollection<string> done, Predicate<Change>? likely)
{
    /// <summary>What explains a picture leaves at most this share of the wrong pixels.</summary>
    public const double Explained = 0.1;

    /// <summary>What explanations cost that are mentioned where none is named, for each picture.</summary>
    public const double Mentioned = 1.5 * Priors.OtherProgram;

    /// <summary>How many of the nearest mistakes are mentioned if none explains the picture.</summary>
    private const int Shown = 3;

    /// <summary>The share of what is drawn wrong that such a mistake explains, at least; of two, the share that each explains of all.</summary>
    private const double LeastExplained = 0.05;

    /// <summary>How many of the best are examined, and how many of them are named.</summary>
    private const int Examined = 12, MaxNamed = 5;

    /// <summary>How many pixels are drawn with each mistake, at most.</summary>
    private const int Pixels = 6000;

    private readonly PictureSample sample = SampleOf(prepared, picture);

    private SuspectFinder Suspects => new(prepared, sample);

    /// <summary>What is known before a mistake is tried.</summary>
    public DiagnosisResult Facts => new()
    {
        TooManyModels = prepared.TooManyModels,
        NotTried = prepared.NotTried,
        ProvesNothing = prepared.Right.IsNearlyOneColor,
        Rounding = sample.Difference is { } difference && difference.OffByOne > PictureJudge.Rounded * difference.Pixels
            ? ComparisonText.RoundedOtherwise(difference) : null,
        PixelCount = sample.PixelCount,
        WrongCount = sample.WrongCount,
        OutlineCount = sample.OutlineCount,
        DarkerShare = sample.DarkerShare,
    };

    /// <summary>Looks at what the picture shows by itself, then for mistakes.</summary>
    public DiagnosisResult Decide()
    {
        if (prepared.Whole(picture) is { } whole && Crop.Find(picture, whole) is { } crop)
            return Facts with { Kind = DiagnosisKind.Cropped, Missing = crop.Missing };
        if (sample.WrongCount == 0 || (prepared.TooManyModels && sample.IsOnlyOutlines)) return Facts with { Kind = DiagnosisKind.Matches };
        var observed = sample.Observe(prepared.Threads);
        if (observed.Plain is { } plain) return Facts with { Kind = DiagnosisKind.TellsNothing, Likely = [plain] };
        return prepared.TooManyModels ? Observed(observed) : Search(observed);
    }

    /// <summary>What is said if no formula explains the picture.</summary>
    private DiagnosisResult Observed(Observations observed) => Facts with
    {
        Kind = observed.Best?.Way == Way.Places ? DiagnosisKind.NotTheFormulas : DiagnosisKind.NoneOfThese,
        Likely = observed.Sentences,
        MissingModel = observed.MissingModels,
        IsOfScene = observed.IsOfScene,
    };

    /// <summary>The pixels that count. If most of the wrong ones lie on outlines, these count too where one mistake explains all of them: a box
    /// that loses its edge to 0 · ∞ is not forgiven.</summary>
    private static PictureSample SampleOf(Diagnoser prepared, Picture picture)
    {
        var (scene, right) = (prepared.Scene, prepared.Right);
        var sample = new PictureSample(scene, right, picture, Pixels, !prepared.TooManyModels, prepared.Budget);
        if (sample.WrongCount >= sample.OutlineCount || sample.OutlineCount <= Rendering.LeastPixels) return sample;
        var strict = new PictureSample(scene, right, picture, Pixels, forgiveOutlines: false, prepared.Budget);
        return prepared.Known.Any(IsAll) ? strict : sample;

        // A mistake of the camera may by chance be the last bits of another program.
        bool IsAll(Mistake mistake) => !mistake.Steps.Any(step => step.IsOfRays()) && mistake.Changes.Any(change => ((double[])[0.1, 1]).All(share =>
            strict.Residual(change.In(FormulaProgram.Slides), share).Unexplained <= Explained * strict.WrongCount));
    }

    /// <summary>Searches, and decides: what is shorter than any other explanation is told.</summary>
    private DiagnosisResult Search(Observations observed)
    {
        var without = new Lazy<double>(() => observed.Best?.Total(sample.WrongCount) ?? Priors.OtherProgram);
        var ranked = new HypothesisSearch([sample], prepared.Known, done, prepared.Threads, likely, prepared.Budget, prepared.Possible,
            sample.Difference is { } difference ? UnreachedLinesFinder.Find(difference) : null, without).Run();
        var best = ranked[0];
        if (best.Total < Priors.LeastWithoutFormulas) return Naming(Facts, best, ranked);
        var (sentence, byNumber) = observed.Best is null ? OtherNumberFor(best, observed) : default;
        if (sentence is not null && byNumber < Math.Min(best.Total, without.Value))
            return Facts with { Kind = DiagnosisKind.NoneOfThese, Likely = [sentence], IsOfScene = true };
        if (best.Total < without.Value) return Naming(Facts, best, ranked);
        if (sample.IsOnlyOutlines) return Facts with { Kind = DiagnosisKind.Matches };
        var none = Observed(observed);
        return observed.Best is not null ? none
            : none with { Nearest = NearestOf(ranked, best, observed.ByModels?.FaultLocalization), IsOpen = true };
    }

    /// <summary>What is said if another number of the scene explains the picture, and its bits; null if none does.</summary>
    private (string? Sentence, double Total) OtherNumberFor(Hypothesis best, Observations observed)
    {
        var isOfCamera = best.Reported.Count > 1 && best.Reported.All(mistake => mistake.Steps.All(step => step.IsOfRays()));
        var price = isOfCamera ? Priors.NumberForTwo : Priors.NumberOfScene;
        if (best.Total <= price || sample.IsOnlyOutlines || observed.ByModels is not { } byModels) return default;
        var (residual, sentence) = GivenNumber.Find(prepared.Scene, byModels, sample, prepared.Threads);
        return residual.Unexplained <= Explained * sample.WrongCount ? (sentence, price + sample.BitsOf(residual)) : default;
    }

    /// <summary>The known mistakes that explain a part of what is drawn wrong; one of thousands of slips would, by chance.</summary>
    private IReadOnlyList<Suspect> NearestOf(List<Hypothesis> ranked, Hypothesis best, FaultLocalization? wrong)
    {
        var background = prepared.Scene.Background.ToBytes();
        return
        [
            .. ranked.Where(candidate => candidate.Mistakes.Count > 0 && candidate.Mistakes.All(mistake => mistake.Mutation is null)
                    && candidate.Total < Mentioned && IsOfTheseKinds(candidate)
                    && sample.ShareExplained(candidate.Program, IsDrawnWrong) >= LeastExplained && candidate.Changes.All(IsNeeded(candidate)))
                .DistinctBy(candidate => IdsOf(candidate.Mistakes)).Take(Shown)
                .OrderBy(candidate => candidate.Residual.Unexplained).Select(candidate => Suspects.Of(candidate, best)),
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
    private DiagnosisResult Naming(DiagnosisResult facts, Hypothesis best, List<Hypothesis> ranked)
    {
        string[] missing = [.. best.MissingShapes];
        if (best.Mistakes.Count == 0 && missing.Length > 0 && sample.BitsOf(best.Residual) > Priors.MissingPart)
        {
            // Beside missing shapes a small mistake counts for little, so the rest is judged by itself.
            var drawn = prepared.Scene with { Models = [.. prepared.Scene.Models.Where(model => !missing.Contains(model.Kind))] };
            var partly = new Diagnoser(drawn, prepared.Threads, prepared.Possible, prepared.Budget);
            var rest = new Decision(partly, sample.Picture, done, likely).Decide();
            if (rest.Kind != DiagnosisKind.Matches)
                return facts with
                {
                    Kind = rest.Kind,
                    NotYet = [.. missing, .. rest.NotYet],
                    Suspects = rest.Suspects,
                    Likely = rest.Likely,
                    IsOfScene = rest.IsOfScene,
                    IsOpen = rest.IsOpen,
                };
        }
        var named = ranked.Where(candidate => candidate.Reported.Count > 0 && candidate.Total < Priors.OtherProgram)
            .DistinctBy(candidate => candidate.Key).Take(Examined);
        if (best.Reported.Count == 0) // what may have lost those shapes, if they are written already
            named = named.Where(candidate => candidate.Missing.Count == 0 && candidate.Total < best.Total + Priors.Known);
        else if (missing.Length > 0) named = named.Take(1);
        if (missing.Length > 0 && prepared.Budget?.IsSpent() != true) named = named.Concat(Suspects.HidingMistakes(best));
        Hypothesis[] first = [.. named.DistinctBy(candidate => IdsOf(candidate.Reported)).Take(MaxNamed)];
        Suspect[] suspects = [.. first.Select(candidate => Suspects.Of(candidate, first[0])).DistinctBy(suspect => IdsOf(suspect.Mistakes))];
        return facts with
        {
            Kind = best.Reported.Count > 0 ? DiagnosisKind.Mistake : best.Missing.Count > 0 ? DiagnosisKind.Unfinished
                : DiagnosisKind.NotTheFormulas,
            NotYet = best.Missing,
            Likely = [.. best.Changes.Select(change => change.Unreached?.Sentence).OfType<string>()],
            Suspects = suspects is [{ Twins: var twins }, ..] // no mistake is told twice
                ? [.. suspects.Where((suspect, i) => i == 0 || suspect.Mistakes is not [var one] || twins.All(twin => twin.Id != one.Id))] : [],
            IsOpen = best.Reported.Count > 0 && best.Residual.Unexplained >= 0.5,
        };
    }

    /// <summary>The same for mistakes in another order, or made in other ways.</summary>
    private static string IdsOf(IEnumerable<Change> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());
}
