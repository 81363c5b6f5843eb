namespace RayCaster.Teaching.Formulas;

/// <summary>A program: its formulas for each step, and the few things that no formula says.</summary>
/// <remarks>It never changes; two programs that differ in a step share the others.</remarks>
internal sealed record FormulaProgram
{
    private FormulaProgram(ImmutableArray<Step> steps) => Steps = steps;

    private ImmutableArray<Step> Steps { get; init; }

    public Step this[StepKind kind] => Steps[(int)kind];

    /// <summary>The rules of some kinds of shape, where they are others than those of all.</summary>
    private ImmutableArray<OwnRule> Rules { get; init; } = [];

    /// <summary>The kinds of shape, by their names in scene files, that are not drawn.</summary>
    public ImmutableHashSet<string> MissingShapes { get; init; } = [];

    /// <summary>By how many bytes all bytes of the picture are farther on in the file.</summary>
    public int ByteShift { get; init; }

    /// <summary>Lines and columns that no loop reaches; null for none.</summary>
    public UnreachedLines? Unreached { get; init; }

    /// <summary>Whether the camera stands at T and looks at P.</summary>
    public bool SwapsEyeAndTarget { get; init; }

    /// <summary>Whether last bits decide for each pixel if a triangle shows there.</summary>
    public bool HasNoisyTriangles { get; init; }

    /// <summary>Whether the file is as wide as the scene's picture is high, and the other way round.</summary>
    public bool IsTurned => this[StepKind.File].Has(Formula.Turned);

    /// <summary>The slides' formulas.</summary>
    public static FormulaProgram Slides { get; } = new([.. Enum.GetValues<StepKind>().Select(kind => FormulaBook.Slides.StylesOf(kind)[0])]);

    /// <summary>The sides of its file.</summary>
    public (int Width, int Height) SizeOf(Camera camera) => IsTurned ? (camera.Height, camera.Width) : (camera.Width, camera.Height);

    /// <summary>The shapes whose own formulas, or whose own rule, are not the slides'.</summary>
    public IEnumerable<ShapeKind> ChangedShapes => ShapeKind.Basic.Where(shape =>
        !FormulaBook.Slides.StylesOf(shape.Step).Contains(this[shape.Step]) || Rules.Any(rule => rule.Shape == shape.Step));

    /// <summary>Whether the triangle's own formulas are not the slides'.</summary>
    public bool MutatesTriangles => !FormulaBook.Slides.StylesOf(StepKind.Triangle).Contains(this[StepKind.Triangle]);

    /// <summary>How many pixels of a picture a thread draws at a time, at most, unless a line has more.</summary>
    private const int PixelsAtOnce = 4096;

    /// <summary>The whole file.</summary>
    public Picture Draw(Scene scene, int? threads = null)
    {
        var (width, height) = SizeOf(scene.Camera);
        var picture = new Picture(width, height);
        var lines = Math.Max(1, PixelsAtOnce / width); // that are drawn together
        Parallel.For(0, (height + lines - 1) / lines, new() { MaxDegreeOfParallelism = threads ?? Environment.ProcessorCount }, i =>
        {
            var first = i * lines;
            (int, int)[] pixels = [.. from y in Enumerable.Range(first, Math.Min(lines, height - first))
                                      from x in Enumerable.Range(0, width)
                                      select (x, y)];
            FormulaEvaluator.Draw(scene, this, pixels).CopyTo(picture.Rgb, 3 * width * first);
        });
        return picture;
    }

    /// <summary>The rule of a kind of shape; of a shape of one's own for null.</summary>
    /// <param name="kind">Which of both rules.</param>
    public Step RuleOf(StepKind? shape, StepKind kind)
    {
        foreach (var own in Rules)
            if (own.Shape == shape && own.Rule.Kind == kind) return own.Rule;
        return this[kind];
    }

    public FormulaProgram With(Step step) => this with { Steps = Steps.SetItem((int)step.Kind, step) };

    /// <summary>With a step in the place of its own; if that has edits, too, with both.</summary>
    /// <param name="step">A style, or one with edits.</param>
    /// <param name="shapes">The kinds of shape whose rule it is; empty for all.</param>
    /// <returns>Null if both edit the same part of a formula, or have different styles.</returns>
    public FormulaProgram? With(Step step, ImmutableArray<StepKind> shapes)
    {
        if (shapes.IsEmpty) return this[step.Kind].Merged(step) is { } merged ? With(merged) : null;
        var rules = Rules;
        foreach (var shape in shapes)
        {
            if (RuleOf(shape, step.Kind).Merged(step) is not { } rule) return null;
            rules = [.. rules.Where(own => own.Shape != shape || own.Rule.Kind != step.Kind), new(shape, rule)];
        }
        return this with { Rules = rules };
    }

    /// <summary>One of both rules of a kind of shape.</summary>
    private sealed record OwnRule(StepKind Shape, Step Rule);
}
