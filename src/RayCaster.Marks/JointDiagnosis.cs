namespace RayCaster.Marks;

/// <summary>What is wrong with a program, by its pictures of several scenes together (<see cref="HypothesisSearch"/>).</summary>
internal sealed record JointDiagnosis
{
    /// <summary>A verdict that changes a picture must not leave a greater share of its wrong pixels unexplained.</summary>
    private const double MayLeave = 0.5;

    /// <summary>If one kind of shape has a greater share of the pixels in the wrong light, its formula may be the reason.</summary>
    private const double OneKind = 0.9;

    /// <summary>One of several mistakes that explains a smaller share of the wrong pixels of each picture may be there by chance.</summary>
    private const double Slight = 0.05;

    /// <summary>What is wrong; a right program if nothing is wrong, or if nothing explains most of the wrong pictures.</summary>
    public Hypothesis Verdict { get; private init; } = new([], []);

    /// <summary>Other programs that explain the pictures as well as the verdict.</summary>
    public IReadOnlyList<Hypothesis> Alternatives { get; private init; } = [];

    /// <summary>The mistakes that draw the same pictures, if the verdict is that shapes are missing: the shapes may be written, and lost.</summary>
    public IReadOnlyList<Change> HidingMistakes { get; private init; } = [];

    /// <summary>The scenes whose pictures are wrong, and which the verdict does not explain.</summary>
    public IReadOnlyList<MarkedScene> Unexplained { get; private init; } = [];

    /// <summary>Whether the verdict changes a picture and leaves more than half of its wrong pixels unexplained. Then it is only a guess in the
    /// other pictures, too.</summary>
    public bool IsGuess { get; private init; }

    /// <summary>Whether the verdict explains all pictures.</summary>
    public bool IsCertain => Unexplained.Count == 0;

    /// <summary>The program that comes nearest where none explains the pictures; null where one does.</summary>
    public Hypothesis? Nearest { get; private init; }

    /// <summary>Where nothing explains the pictures but only the light is wrong, the steps of which one must be wrong; otherwise null.</summary>
    public IReadOnlyCollection<StepKind>? Steps { get; private init; }

    /// <summary>What the teacher should know about these steps.</summary>
    public string? Note { get; private init; }

    /// <summary>What the wrong pictures show that is no mistake of the formulas; null if nothing does.</summary>
    public string? Cause { get; private init; }

    /// <summary>Whether each picture is of one colour: many mistakes cause that.</summary>
    public bool TellsNothing { get; private init; }

    /// <summary>Finds what is wrong.</summary>
    /// <param name="pictures">Those of a program's pictures that can be judged.</param>
    /// <param name="known">The mistakes that it may have.</param>
    public static JointDiagnosis Find(IReadOnlyList<SubmittedPicture> pictures, IReadOnlyList<Mistake> known)
    {
        int[] wrong = [.. Enumerable.Range(0, pictures.Count).Where(i => !pictures[i].Sample.IsRight)];
        if (wrong.Length == 0) return new();
        if (pictures.All(picture => picture.Sample.Picture.IsNearlyOneColor))
            return new() { TellsNothing = true, Unexplained = [.. wrong.Select(i => pictures[i].Scene)] };
        if (NotTheFormulas([.. wrong.Select(i => pictures[i])]) is { } cause)
            return new() { Unexplained = [.. wrong.Select(i => pictures[i].Scene)], Cause = cause };
        var found = Search(pictures, known);
        int[] unexplained = [.. wrong.Where(i => !pictures[i].Sample.IsExplainedBy(found.Verdict.Programs[i]))];
        if (2 * unexplained.Length < wrong.Length)
        {
            return found with
            {
                Unexplained = [.. unexplained.Select(i => pictures[i].Scene)],
                Alternatives = WithoutSlight(found.Verdict, pictures, wrong) is { } less ? [.. found.Alternatives, less] : found.Alternatives,
                IsGuess = unexplained.Any(i => IsHardlyExplained(found.Verdict.Programs[i], pictures[i])),
            };
        }
        var (steps, note) = OnlyLight([.. wrong.Select(i => pictures[i])]);
        return new()
        {
            Unexplained = [.. wrong.Select(i => pictures[i].Scene)],
            Nearest = found.Verdict.Told.Count > 0 && found.Verdict.Total < Decision.Mentioned * wrong.Length ? found.Verdict : null,
            Steps = steps,
            Note = note ?? OnlyKind([.. wrong.Select(i => pictures[i])]),
        };
    }

    /// <summary>A sentence for the first of some pictures if each has too few colours, or is right but for pixels that no loop reached.</summary>
    private static string? NotTheFormulas(SubmittedPicture[] wrong)
    {
        string?[] causes = [.. wrong.Select(CauseOf)];
        return causes.Contains(null) ? null : causes[0];

        static string? CauseOf(SubmittedPicture picture)
        {
            if (picture.Sample.Difference is not { } difference) return null;
            return FewColors.Find(difference)
                ?? (UnreachedPixels.Find(difference, picture.Scene.Scene) is { IsRestRight: true } unreached ? unreached.Sentence : null);
        }
    }

    /// <summary>Whether a kind of shape shows in the pictures that the verdict draws.</summary>
    public bool Draws(string kind, IReadOnlyList<SubmittedPicture> pictures)
    {
        if (Verdict.Plus(ChangeSource.Missing(kind)) is not { } without) return false; // it is missing
        return pictures.Index().Any(picture => picture.Item.Scene.Scene.Models.Any(model => model.Kind == kind)
            && Weight(without.Programs[picture.Index], picture.Item)
                > Weight(Verdict.Programs[picture.Index], picture.Item) + picture.Item.Sample.LeastPixels);
    }

    /// <summary>The program that leaves the least, and those that leave as little.</summary>
    private static JointDiagnosis Search(IReadOnlyList<SubmittedPicture> pictures, IReadOnlyList<Mistake> known)
    {
        var ranked = new HypothesisSearch([.. pictures.Select(picture => picture.Sample)], known, [], 1, null, null, null).Run();
        var verdict = ranked[0];
        var alike = ranked.TakeWhile(other => other.Total < verdict.Total + Priors.AsLikely);
        return new()
        {
            Verdict = verdict,
            HidingMistakes = verdict.MissingShapes.Count == 0 ? []
                : [.. ranked.TakeWhile(other => other.Total < verdict.Total + Priors.Known)
                    .Where(other => other is { Missing.Count: 0, HasOtherSample: false, Mistakes.Count: 1 })
                    .Select(other => other.Mistakes[0]).DistinctBy(mistake => mistake.Id)],
            Alternatives =
            [
                .. alike.Where(other => other.Count == verdict.Count)
                    .Where(other => other.Key != verdict.Key).DistinctBy(other => other.Key),
            ],
        };
    }

    /// <summary>A program without one of its mistakes or missing parts, if this explains only a few pixels; otherwise null.</summary>
    private static Hypothesis? WithoutSlight(Hypothesis program, IReadOnlyList<SubmittedPicture> pictures, int[] wrong)
    {
        var (missing, mistakes) = program.Count;
        return missing + mistakes < 2 ? null : program.Changes
            .Where(change => change.Missing is not null).Concat(program.Mistakes)
            .Select(change => Hypothesis.Of(pictures.Select(picture => picture.Scene.Scene), program.Changes.Remove(change)))
            .FirstOrDefault(less => wrong.All(i => Weight(less!.Programs[i], pictures[i]) - Weight(program.Programs[i], pictures[i])
                < Slight * Weight(Right(pictures[i]), pictures[i])));
    }

    private static FormulaProgram Right(SubmittedPicture picture) => FormulaProgram.For(picture.Scene.Scene.Camera);

    private static double Weight(FormulaProgram program, SubmittedPicture picture) => picture.Sample.Residual(program).Weight;

    private static bool IsHardlyExplained(FormulaProgram program, SubmittedPicture picture)
    {
        var left = picture.Sample.Residual(program);
        var all = picture.Sample.Residual(Right(picture));
        return left != all && left.Weight > MayLeave * all.Weight;
    }

    /// <summary>
    /// The steps where all outlines are right and only the light is not. If it is wrong on one kind of shape, this one's formula may be the reason.
    /// </summary>
    private static (IReadOnlyCollection<StepKind>? Steps, string? Note) OnlyLight(SubmittedPicture[] wrong)
    {
        var kinds = wrong.Select(picture => LikelyCause.InAnotherLight(picture.Sample, new Renderer(picture.Scene.Scene).CastHits().Model))
            .TakeWhile(kinds => kinds.Count > 0).ToList();
        if (kinds.Count < wrong.Length) return default;
        var counts = kinds.SelectMany(kinds => kinds).GroupBy(kind => kind.Key, kind => kind.Value)
            .ToDictionary(kind => kind.Key, kind => kind.Sum());
        var most = counts.MaxBy(kind => kind.Value);
        var isOneKind = most.Value >= OneKind * counts.Values.Sum();
        return (isOneKind && Enum.TryParse<StepKind>(most.Key == "mesh" ? "triangle" : most.Key, true, out var shape)
                ? [StepKind.Light, StepKind.Bytes, shape] : [StepKind.Light, StepKind.Bytes],
            isOneKind && most.Key == "background" ? "only the background is wrong" : "all outlines are right, only the light is not");
    }

    /// <summary>What the teacher should know where all pictures prove that one kind of shape is wrong and all else is right.</summary>
    private static string? OnlyKind(SubmittedPicture[] wrong)
    {
        var kinds = wrong.Select(picture => picture.Sample.Difference is { } difference
            ? new SceneDifference(picture.Scene.Scene, difference, 1).WrongKinds.Kinds : []).ToArray();
        return kinds.All(kind => kind.Count == 1) && kinds.Select(kind => kind[0]).Distinct().ToArray() is [var only]
            ? $"only {WrongKinds.ManyOf(only)} are wrong" : null;
    }
}
