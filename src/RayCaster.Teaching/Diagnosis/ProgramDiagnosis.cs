namespace RayCaster.Teaching.Diagnosis;

/// <summary>What is wrong with a program, by its pictures of several scenes together: a mistake that one of them proves explains the others, too.
/// </summary>
public sealed record ProgramDiagnosis
{
    /// <summary>If one kind of shape has a greater share of the pixels in the wrong light, its formula may be the reason.</summary>
    private const double OneKind = 0.9;

    /// <summary>How many pixels of each picture are compared with each mistake, at most.</summary>
    private const int Pixels = 3000;

    /// <summary>The steps of which one must be wrong, where nothing explains the pictures but only the light is wrong; otherwise null.</summary>
    private readonly IReadOnlyCollection<StepKind>? stepsOfLight;

    private ProgramDiagnosis(IReadOnlyCollection<StepKind>? stepsOfLight = null) => this.stepsOfLight = stepsOfLight;

    /// <summary>The mistakes; none if nothing is wrong, or if nothing explains most of the wrong pictures.</summary>
    public Suspect Verdict { get; private init; } = Suspect.None;

    /// <summary>Other mistakes that explain the pictures as well as the verdict.</summary>
    public IReadOnlyList<Suspect> Alternatives { get; private init; } = [];

    /// <summary>The mistakes that draw the same pictures, if the verdict is that shapes are missing: the shapes may be written, and lost.</summary>
    public IReadOnlyList<Change> HidingMistakes { get; private init; } = [];

    /// <summary>The places of the wrong pictures among all.</summary>
    public IReadOnlyList<int> Wrong { get; private init; } = [];

    /// <summary>The places of the wrong pictures that the verdict does not explain.</summary>
    public IReadOnlyList<int> Unexplained { get; private init; } = [];

    /// <summary>Whether the verdict changes a picture that it does not explain. Then it is only a guess in the other pictures, too.</summary>
    public bool IsGuess { get; private init; }

    /// <summary>Whether the verdict explains all pictures.</summary>
    public bool IsCertain => Unexplained.Count == 0;

    /// <summary>The mistakes that come nearest where none explains the pictures; null where some do.</summary>
    public Suspect? Nearest { get; private init; }

    /// <summary>The kinds of shape that show in the pictures that the verdict draws, if the verdict has mistakes.</summary>
    public IReadOnlyList<string> Drawn { get; private init; } = [];

    /// <summary>Whether nothing explains the pictures, but only the light is wrong.</summary>
    public bool IsOnlyLight => stepsOfLight is not null;

    /// <summary>What the teacher should know where nothing explains the pictures; null for nothing.</summary>
    public string? Note { get; private init; }

    /// <summary>What the wrong pictures show that is no mistake of the formulas, a sentence for each, by their places; none if one shows nothing of
    /// the kind.</summary>
    public IReadOnlyDictionary<int, string> Causes { get; private init; } = new Dictionary<int, string>();

    /// <summary>Whether each picture is of one colour: many mistakes cause that.</summary>
    public bool TellsNothing { get; private init; }

    /// <summary>Slips in formulas that explain the pictures and have no name.</summary>
    public IEnumerable<Change> Slips =>
        Alternatives.Prepend(Verdict).SelectMany(suspect => suspect.AllMistakes).Where(mistake => mistake.Place is not null);

    /// <summary>Finds what is wrong.</summary>
    /// <param name="pictures">A program's pictures, each with its scene; their sizes pass <see cref="Diagnoser.CanJudge"/>.</param>
    /// <param name="known">The mistakes that it may have.</param>
    public static ProgramDiagnosis Find(IReadOnlyList<(Diagnoser Scene, Picture Picture)> pictures, IReadOnlyList<Mistake> known)
    {
        PictureSample[] samples = [.. pictures.Select(picture => picture.Scene.Sample(picture.Picture, Pixels))];
        int[] wrong = [.. Enumerable.Range(0, samples.Length).Where(i => !samples[i].IsRight)];
        if (wrong.Length == 0) return new();
        Observations[] observed = [.. wrong.Select(i => samples[i].Observe(1))];
        var decision = new Decision(samples, wrong, observed, new(known, [], Threads: 1));
        var none = new ProgramDiagnosis { Wrong = wrong, Unexplained = wrong };
        if (decision.TellsNothing) return none with { TellsNothing = true };
        var (verdict, ranked) = (decision.Best, decision.Ranked);
        if (!decision.IsNamed)
        {
            var (steps, note) = OnlyLight(observed);
            none = new(steps) { Wrong = wrong, Unexplained = wrong };
            return observed.All(of => of.Best is not null)
                ? none with { Causes = wrong.Zip(observed.Select(of => of.Best!.Sentence)).ToDictionary() }
                : none with
                {
                    Nearest = verdict.Reported.Count > 0 && decision.IsMentioned(verdict) ? Find(verdict) : null,
                    Note = note ?? OnlyKind(observed),
                };
        }
        return none with
        {
            Unexplained = verdict.Unreached is null ? decision.Unexplained : wrong, // what was not drawn may hide anything
            Causes = verdict.Unreached is not { } lines ? none.Causes : new Dictionary<int, string> { [wrong[0]] = lines }, // of one picture
            Verdict = Find(verdict),
            Alternatives = [.. AsGood(verdict, ranked).Select(Find)],
            HidingMistakes = verdict.MissingShapes.Count > 0 ? [.. Hiding(verdict, ranked)] : [],
            Drawn = verdict.Mistakes.Count > 0 ? [.. KindsIn(samples).Where(kind => Draws(verdict, kind, samples))] : [],
            IsGuess = decision.Unexplained.Any(i => Weight(verdict.Program, samples[i]) != Weight(FormulaProgram.Slides, samples[i])),
        };
    }

    /// <summary>Whether something unnamed may be wrong in the formulas of a part of a program (<see cref="MissingPart.All"/>).</summary>
    public bool MayBeIn(string part) =>
        OpenSteps.Any(step => part == (step is StepKind.Light ? MissingPart.Attenuation : step.InWords()));

    /// <summary>Whether something unnamed may be wrong in the formulas that a mistake changes.</summary>
    public bool MayBeIn(Mistake mistake) => OpenSteps.Any(step => step.IsOfColors() ? mistake.Steps.Any(touched => touched.IsOfColors())
        : mistake.Slide == FormulaBook.Slides.StylesOf(step)[0].Slide);

    private IEnumerable<StepKind> OpenSteps => Slips.SelectMany(slip => slip.Place!.Steps).Concat(stepsOfLight ?? []);

    private static Suspect Find(Hypothesis hypothesis) => new(
        hypothesis.Mistakes, hypothesis.Residual.Unexplained, hypothesis.HasOtherSample, [], hypothesis.MissingParts,
        false, false, hypothesis.IsUsual);

    /// <summary>Programs of as many mistakes as the verdict that are about as short.</summary>
    private static IEnumerable<Hypothesis> AsGood(Hypothesis verdict, List<Hypothesis> ranked) =>
        ranked.TakeWhile(other => other.Total < verdict.Total + Priors.AsLikely)
            .Where(other => other.Key != verdict.Key).DistinctBy(other => other.Key);

    private static IEnumerable<Change> Hiding(Hypothesis verdict, List<Hypothesis> ranked) =>
        ranked.TakeWhile(other => other.Total < verdict.Total + Priors.Known)
            .Where(other => other is { MissingParts.Count: 0, HasOtherSample: false, Mistakes.Count: 1 })
            .Select(other => other.Mistakes[0]).DistinctBy(mistake => mistake.Id);

    private static IEnumerable<string> KindsIn(PictureSample[] samples) =>
        samples.SelectMany(sample => sample.Scene.Models.Select(model => model.Kind)).Distinct();

    /// <summary>Whether a kind of shape shows in the pictures that a program draws.</summary>
    private static bool Draws(Hypothesis program, string kind, PictureSample[] samples)
    {
        if (program.Plus(ChangeSource.Missing(kind)) is not { } without) return false; // it is missing
        return samples.Any(sample => sample.Scene.Models.Any(model => model.Kind == kind)
            && Weight(without.Program, sample) > Weight(program.Program, sample) + sample.LeastPixels);
    }

    private static double Weight(FormulaProgram program, PictureSample sample) => sample.Residual(program).Weight;

    /// <summary>
    /// The steps where all outlines are right and only the light is not. If it is wrong on one kind of shape, this one's formula may be the reason.
    /// </summary>
    private static (IReadOnlyCollection<StepKind>? Steps, string? Note) OnlyLight(IReadOnlyList<Observations> wrong)
    {
        var kinds = wrong.Select(of => of.OtherLight).TakeWhile(kinds => kinds.Count > 0).ToList();
        if (kinds.Count < wrong.Count) return default;
        var counts = kinds.SelectMany(kinds => kinds).GroupBy(kind => kind.Key, kind => kind.Value)
            .ToDictionary(kind => kind.Key, kind => kind.Sum());
        var most = counts.MaxBy(kind => kind.Value);
        var isOneKind = most.Value >= OneKind * counts.Values.Sum();
        return (isOneKind && ShapeKind.Find(most.Key) is { } shape ? [StepKind.Light, StepKind.Bytes, shape.Step] : [StepKind.Light, StepKind.Bytes],
            isOneKind && most.Key == "background" ? "only the background is wrong" : "all outlines are right, only the light is not");
    }

    /// <summary>What the teacher should know where all pictures prove that one kind of shape is wrong and all else is right.</summary>
    private static string? OnlyKind(IReadOnlyList<Observations> wrong)
    {
        var kinds = wrong.Select(of => of.ByModels?.FaultLocalization.Kinds ?? []).ToArray();
        return kinds.All(kind => kind.Count == 1) && kinds.Select(kind => kind[0]).Distinct().ToArray() is [var only]
            ? $"only {MissingPart.Many(only)} are wrong" : null;
    }
}
