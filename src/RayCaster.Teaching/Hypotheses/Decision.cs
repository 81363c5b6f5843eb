namespace RayCaster.Teaching.Hypotheses;

/// <summary>Decides which of the hypotheses that a search has found are named, and which sentences the diagnosis has if none is.</summary>
/// <param name="picture">The picture; its size is the scene's, or the scene's with width and height swapped.</param>
/// <param name="done">What the program certainly draws.</param>
/// <param name="likely">Which mistakes are likelier than the others; null for none.</param>
/// <param name="isLeftOut">Which pixels are not compared, by their places; none if null.</param>
internal sealed class Decision(SceneDiagnosis prepared, Picture picture, IReadOnlyCollection<string> done, Predicate<Change>? likely,
    Func<int, bool>? isLeftOut = null)
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

    private readonly PictureSample sample = SampleOf(prepared, picture, isLeftOut);

    private SuspectFinder Suspects => new(prepared, sample);

    /// <summary>What is known before a mistake is tried.</summary>
    public Diagnosis Facts => new()
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
    public Diagnosis Decide()
    {
        if (prepared.Whole(picture) is { } whole && Crop.Find(picture, whole) is { } crop)
            return Facts with { Kind = DiagnosisKind.Cropped, Missing = crop.Missing };
        if (sample.WrongCount == 0 || (prepared.TooManyModels && sample.IsOnlyOutlines)) return Facts with { Kind = DiagnosisKind.Matches };
        if (WithoutFormulas() is { } diagnosis) return diagnosis;
        var plain = PlainPicture.Describe(prepared.Scene, picture, prepared.Right);
        var tellsNothing = Facts with { Kind = DiagnosisKind.TellsNothing, Likely = plain is null ? [] : [plain] };
        if (plain is not null && (prepared.TooManyModels || !PlainPicture.IsOneShade(prepared.Scene, picture))) return tellsNothing;
        if (prepared.TooManyModels) return Facts with { Kind = DiagnosisKind.NoneOfThese };
        var found = Search();
        if (plain is null) return found;
        // All but a mistake that casts the same ray through all pixels would explain one colour by chance.
        found = found with
        {
            Suspects = [.. found.Suspects.Take(1).Where(IsOneRay)],
        };
        return found.Suspects.Count > 0 ? found : tellsNothing with { MissingModel = found.MissingModel };
    }

    /// <summary>Whether a mistake of the rays alone explains all of a picture.</summary>
    private static bool IsOneRay(Suspect suspect) =>
        suspect is { Mistakes: [{ Id: not Change.NoName } mistake], NotYet.Count: 0, Unexplained: < 0.5 }
        && mistake.Steps.All(step => step.IsOfRays());

    /// <summary>What is said if no loop reached some pixels; otherwise null. The rest of the picture is judged by itself.</summary>
    private Diagnosis? WithoutFormulas()
    {
        if (sample.Difference is not { } difference) return null;
        if (UnreachedPixels.Find(difference, prepared.Scene) is not { } unreached) return null;
        if (!prepared.TooManyModels && AreDrawn(unreached, OneChange()))
        {
            if (!unreached.IsRestRight) return null;
            var found = Search();
            return IsOfFile(found) ? found with { Likely = [unreached.Sentence, .. found.Likely] } : found;
        }
        if (unreached.IsRestRight) return Facts with { Kind = DiagnosisKind.NotTheFormulas, Likely = [unreached.Sentence] };
        if (prepared.TooManyModels) return null;
        var rest = new Decision(prepared, unreached.Rest, done, likely, unreached.Contains).Decide();
        if (rest.Suspects is [var suspect, ..]
            && AreDrawn(unreached, [Hypothesis.Create([prepared.Scene], suspect.Mistakes)?.Programs[0]])) return null;
        return rest with
        {
            Kind = rest.Kind == DiagnosisKind.Matches ? DiagnosisKind.NotTheFormulas : rest.Kind,
            Likely = [unreached.Sentence, .. rest.Likely],
            WrongCount = sample.WrongCount,
        };
    }

    /// <summary>Whether the first suspect is a mistake in the places that a program writes to.</summary>
    private static bool IsOfFile(Diagnosis found) =>
        found.Suspects is [{ Mistakes: [var mistake] }, ..] && mistake.Steps.All(step => step == StepKind.File);

    /// <summary>The programs with one known mistake, or without a kind of shape.</summary>
    private IEnumerable<FormulaProgram?> OneChange()
    {
        var right = FormulaProgram.For(prepared.Scene.Camera);
        return prepared.Known.SelectMany(mistake => mistake.Changes)
            .Concat(prepared.Scene.Models.Select(model => model.Kind).Distinct().Select(ChangeSource.Missing)).Select(change => change.In(right));
    }

    /// <summary>Whether one of some programs gives these pixels their colour and explains much of the picture: then it has reached them.</summary>
    private bool AreDrawn(UnreachedPixels unreached, IEnumerable<FormulaProgram?> programs)
    {
        var area = new PictureSample(prepared.Scene, prepared.Right, picture, Pixels, forgiveOutlines: false, prepared.Budget,
            pixel => !unreached.Contains(pixel));
        return programs.Any(program => area.Residual(program, 0.1).Unexplained <= Explained * area.WrongCount
            && sample.Residual(program).Unexplained <= sample.WrongCount - (1 - Explained) * area.WrongCount);
    }

    /// <summary>The pixels that count. If most of the wrong ones lie on outlines, these count too where one mistake explains all of them: a box
    /// that loses its edge to 0 · ∞ is not forgiven.</summary>
    private static PictureSample SampleOf(SceneDiagnosis prepared, Picture picture, Func<int, bool>? isLeftOut)
    {
        var (scene, right) = (prepared.Scene, prepared.Right);
        var sample = new PictureSample(scene, right, picture, Pixels, !prepared.TooManyModels, prepared.Budget, isLeftOut);
        if (sample.WrongCount >= sample.OutlineCount || sample.OutlineCount <= MutationCoverage.LeastPixels) return sample;
        var strict = new PictureSample(scene, right, picture, Pixels, forgiveOutlines: false, prepared.Budget, isLeftOut);
        return prepared.Known.Any(IsAll) ? strict : sample;

        // A mistake of the camera may by chance be the last bits of another program.
        bool IsAll(Mistake mistake) => !mistake.Steps.Any(step => step.IsOfRays()) && mistake.Changes.Any(change => ((double[])[0.1, 1]).All(share =>
            strict.Residual(change.In(FormulaProgram.For(scene.Camera)), share).Unexplained <= Explained * strict.WrongCount));
    }

    /// <summary>Searches, and decides: named is what is shorter than any other explanation.</summary>
    private Diagnosis Search()
    {
        var byModels = sample.Difference is { } difference ? new SceneDifference(prepared.Scene, difference, prepared.Threads) : null;
        var missing = byModels?.MissingModel;
        var byMissingModel = missing is { } model ? Priors.MissingModel + sample.BitsOf(sample.Residual(
            prepared.Scene with { Models = [.. prepared.Scene.Models.Where((_, i) => i != model)] }, FormulaProgram.For(prepared.Scene.Camera)))
            : double.PositiveInfinity;
        var none = Facts with
        {
            Kind = DiagnosisKind.NoneOfThese,
            MissingModel = missing is { } lost ? ModelName.Format(prepared.Scene, lost) : null,
            IsOfScene = byModels?.WrongKinds.IsCertain == true,
        };

        var ranked = new HypothesisSearch([sample], prepared.Known, done, prepared.Threads, likely, prepared.Budget, prepared.Possible).Run();
        var best = ranked[0];
        var isEnough = best.Total < Math.Min(Priors.OtherProgram, byMissingModel);
        var (sentences, byNumber) = missing is null ? OtherCause(best, byModels, isEnough) : ([], double.PositiveInfinity);
        if (isEnough && best.Total <= byNumber) return Naming(none, best, ranked, sentences);

        if (sample.IsOnlyOutlines) return none with { Kind = DiagnosisKind.Matches };
        if (missing is not null) return none;
        if (byNumber < best.Total) return none with { Likely = sentences, IsOfScene = true };
        if (sentences.Count == 0 && LikelyCause.OfTheWhole(sample) is { } whole) sentences = [whole];
        return none with { Likely = sentences, Nearest = NearestOf(ranked, best, byModels?.WrongKinds), IsOpen = true };
    }

    /// <summary>The sentences about another cause, and the bits of its explanation of the picture.</summary>
    private (IReadOnlyList<string> Sentences, double Total) OtherCause(Hypothesis best, SceneDifference? byModels, bool isEnough)
    {
        var isOfCamera = best.Told.Count > 1 && best.Told.All(mistake => mistake.Steps.All(step => step.IsOfRays()));
        var price = isOfCamera ? Priors.NumberForTwo : Priors.NumberOfScene;
        if (best.Total <= price || sample.IsOnlyOutlines || byModels is null)
            return ([], double.PositiveInfinity);
        var (residual, certain) = LikelyCause.Certain(prepared, byModels, sample);
        var total = certain is null ? double.PositiveInfinity : price + sample.BitsOf(residual);
        if (total < best.Total) return ([certain!], total);
        return (isEnough ? [] : [.. LikelyCause.Hints(byModels, sample)], double.PositiveInfinity);
    }

    /// <summary>The known mistakes that explain a part of what is drawn wrong; one of thousands of slips would, by chance.</summary>
    private IReadOnlyList<Suspect> NearestOf(List<Hypothesis> ranked, Hypothesis best, WrongKinds? wrong)
    {
        var background = prepared.Scene.Background.ToBytes();
        return
        [
            .. ranked.Where(candidate => candidate.Mistakes.Count > 0 && candidate.Mistakes.All(mistake => mistake.Mutant is null)
                    && candidate.Total < Mentioned && IsOfTheseKinds(candidate)
                    && sample.ShareExplained(candidate.Programs[0], IsDrawnWrong) >= LeastExplained && candidate.Changes.All(IsNeeded(candidate)))
                .DistinctBy(candidate => IdsOf(candidate.Mistakes)).Take(Shown)
                .OrderBy(candidate => candidate.Residual.Unexplained).Select(candidate => Suspects.Of(candidate, best)),
        ];

        bool IsOfTheseKinds(Hypothesis candidate) => wrong is null or { Kinds.Count: 0, Agreeing.Count: 0 } || candidate.Mistakes.All(mistake =>
            wrong.Kinds.Count > 0 ? mistake.Steps.Any(step => wrong.Kinds.Any(kind => ShapeKind.Find(kind)?.Step == step))
                : !mistake.Steps.All(step => step.IsOfRays()));

        bool IsDrawnWrong((byte, byte, byte) shown) => wrong is { Kinds.Count: > 0 } ? wrong.ShowsColor(shown)
            : shown != background && shown != default;

        Func<Change, bool> IsNeeded(Hypothesis candidate) => change => candidate.Changes.Length == 1
            || Hypothesis.Create([prepared.Scene], candidate.Changes.Remove(change)) is not { } less
            || sample.Residual(less.Programs[0]).Unexplained > candidate.Residual.Unexplained + LeastExplained * sample.WrongCount;
    }

    /// <summary>Names the best candidate, and others that also explain the picture.</summary>
    private Diagnosis Naming(Diagnosis facts, Hypothesis best, List<Hypothesis> ranked, IReadOnlyList<string> sentences)
    {
        string[] missing = [.. best.MissingShapes];
        if (best.Mistakes.Count == 0 && missing.Length > 0 && sample.BitsOf(best.Residual) > Priors.NotYet)
        {
            // Beside missing shapes a small mistake counts for little, so the rest is judged by itself.
            var drawn = prepared.Scene with { Models = [.. prepared.Scene.Models.Where(model => !missing.Contains(model.Kind))] };
            var partly = new SceneDiagnosis(drawn, prepared.Threads, prepared.Possible, prepared.Budget);
            var rest = new Decision(partly, sample.Picture, done, likely, isLeftOut).Decide();
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
        var named = ranked.Where(candidate => candidate.Told.Count > 0 && candidate.Total < Priors.OtherProgram)
            .DistinctBy(candidate => candidate.Key).Take(Examined);
        if (best.Told.Count == 0) // what may have lost those shapes, if they are written already
            named = named.Where(candidate => candidate.Missing.Count == 0 && candidate.Total < best.Total + Priors.Known);
        else if (missing.Length > 0) named = named.Take(1);
        if (missing.Length > 0 && prepared.Budget?.IsSpent() != true) named = named.Concat(Suspects.HidingMistakes(best));
        Hypothesis[] first = [.. named.DistinctBy(candidate => IdsOf(candidate.Told)).Take(MaxNamed)];
        Suspect[] suspects = [.. first.Select(candidate => Suspects.Of(candidate, first[0])).DistinctBy(suspect => IdsOf(suspect.Mistakes))];
        return facts with
        {
            Kind = best.Told.Count > 0 ? DiagnosisKind.Mistake : DiagnosisKind.Unfinished,
            NotYet = best.Missing,
            Likely = sentences,
            Suspects = suspects is [{ Twins: var twins }, ..] // no mistake is told twice
                ? [.. suspects.Where((suspect, i) => i == 0 || suspect.Mistakes is not [var one] || twins.All(twin => twin.Id != one.Id))] : [],
            IsOpen = best.Told.Count > 0 && best.Residual.Unexplained >= 0.5,
        };
    }

    /// <summary>The same for mistakes in another order, or made in other ways.</summary>
    private static string IdsOf(IEnumerable<Change> mistakes) => string.Join(' ', mistakes.Select(mistake => mistake.Id).Order());
}
