namespace RayCaster.Teaching;

/// <summary>What people write who make a mistake: other formulas of some steps, or other styles of them.</summary>
/// <param name="Steps">What all of it is; each changes another step.</param>
internal sealed record WrittenChange(ImmutableArray<WrittenStep> Steps)
{
    /// <summary>Whether it is what another change is in scenes that measure depth, or sample pixels, otherwise.</summary>
    public bool IsForAnotherSceneThan(WrittenChange other) =>
        (Steps[0], other.Steps[0]) is ({ Style: { } own, Kind: SectionKind.Rule or SectionKind.Sample } one, { Style: { } style } two)
        && one.Kind == two.Kind && own != style && one.Shapes.SequenceEqual(two.Shapes);

    /// <summary>The kinds of shape that its first step is for.</summary>
    public string ShapesInWords
    {
        get
        {
            string[] words = [.. Steps[0].Shapes.Select(shape => ShapeKind.Of(shape.ToString().ToLowerInvariant())!.Many)];
            return words.Length > 1 ? $"{string.Join(", ", words[..^1])} and {words[^1]}" : string.Concat(words);
        }
    }

    /// <summary>A program with it; null if the program has changes of the same places, or another style.</summary>
    public FormulaProgram? In(FormulaProgram program) => Steps.Aggregate((FormulaProgram?)program, (all, step) => all is null ? null : step.In(all));

    /// <summary>Reads a line of Mistakes.txt: several, if shapes or styles are to be tried one by one.</summary>
    public static IEnumerable<WrittenChange> Read(string line)
    {
        List<WrittenStep> steps = [];
        foreach (var part in line.Split("; "))
        {
            var (step, formula) = WrittenStep.Read(part);
            if (step is not null) steps.Add(step);
            if (formula is { } written) steps[^1] = steps[^1] with { Written = steps[^1].Written.Add(written) };
        }
        return steps.Aggregate((IEnumerable<ImmutableArray<WrittenStep>>)[[]], (all, step) =>
            from before in all from choice in step.Choices select before.Add(choice)).Select(all => new WrittenChange(all));
    }
}

/// <summary>Other formulas of a step, or another style of it, or what no formula says.</summary>
/// <param name="Kind">The step; null for what no formula says.</param>
/// <param name="Style">The style; the scene's, or the first one, if null.</param>
/// <param name="Shapes">The kinds of shape whose rule it is; empty for all.</param>
internal sealed record WrittenStep(
    SectionKind? Kind, string? Style, ImmutableArray<SectionKind> Shapes, ImmutableArray<(string Name, string Right)> Written)
{
    private static readonly SectionKind[] shapes =
        [SectionKind.Plane, SectionKind.Sphere, SectionKind.Aabb, SectionKind.Circle, SectionKind.Triangle];

    /// <summary>What "some" shapes are: each kind, the solid ones, the flat ones.</summary>
    private static readonly ImmutableArray<SectionKind>[] some =
    [
        .. shapes.Select(shape => (ImmutableArray<SectionKind>)[shape]), [SectionKind.Sphere, SectionKind.Aabb],
        [SectionKind.Plane, SectionKind.Circle, SectionKind.Triangle],
    ];

    private readonly Dictionary<FormulaSection, FormulaSection> edited = [];

    /// <summary>What is to be done that no formula says.</summary>
    private Func<FormulaProgram, FormulaProgram?>? Other { get; init; }

    private string[] Styles { get; init; } = [];

    private bool IsForSome { get; init; }

    /// <summary>What its formulas are for.</summary>
    public Affects Affects { get; init; } = Kind is { } kind ? Mistake.AffectedBy(kind) : 0;

    /// <summary>This, once for each style and for some shapes.</summary>
    public IEnumerable<WrittenStep> Choices =>
        from style in Styles.Length > 0 ? Styles : (string?[])[Style]
        from own in IsForSome ? some : [Shapes]
        select this with { Style = style, Shapes = own, IsForSome = false, Styles = [] };

    /// <summary>The step's section in the style that a program has, or should have.</summary>
    public FormulaSection In(FormulaSection section)
    {
        if (Written.IsEmpty) return section;
        lock (edited)
        {
            return edited.TryGetValue(section, out var known) ? known
                : edited[section] = Written.Aggregate(section, (all, formula) => all.With(formula.Name, formula.Right));
        }
    }

    public FormulaProgram? In(FormulaProgram program)
    {
        if (Kind is not { } kind) return Other!(program);
        var isOfScene = kind is SectionKind.Rule or SectionKind.Sample;
        var own = program[kind].Style;
        if (isOfScene && Style is not null && Style != own) return null;
        var slides = FormulaBook.Slides;
        return program.With(In(Style is not null ? slides[kind, Style] : isOfScene ? slides[kind, own] : slides.StylesOf(kind)[0]), Shapes);
    }

    /// <summary>Reads "for SHAPES STEP/STYLE NAME = EXPRESSION", all but the step or the formula left out.</summary>
    public static (WrittenStep? Step, (string Name, string Right)? Formula) Read(string text)
    {
        if (OtherOf(text) is { } other) return (other, null);
        var words = text.Split(' ');
        var isFor = words[0] == "for";
        if (isFor) words = words[1..];
        var isForSome = isFor && words[0] == "some";
        ImmutableArray<SectionKind> own = isFor && !isForSome ? [.. words[0].Split('+').Select(word => KindOf(word) ?? throw Unknown(text))] : [];
        if (isFor) words = words[1..];
        var step = words[0].Split('/');
        if (KindOf(step[0]) is not { } kind) return (null, FormulaOf(text));
        var styles = step.Length > 1 ? step[1].Split('|') : [];
        var rest = string.Join(' ', words[1..]);
        return (new(kind, styles is [var only] ? only : null, own, []) { Styles = styles.Length > 1 ? styles : [], IsForSome = isForSome },
            rest == "" ? null : FormulaOf(rest));

        (string, string) FormulaOf(string written) => written.StartsWith("hits ", StringComparison.Ordinal) ? ("hits", written[5..])
            : written.Split(" = ") is [var name, var right] ? (name, right) : throw Unknown(text);
    }

    private static SectionKind? KindOf(string word) => Enum.TryParse<SectionKind>(word, ignoreCase: true, out var kind) ? kind : null;

    /// <summary>What no formula says: it changes what all of them are given, or the bytes that they have computed.</summary>
    private static WrittenStep? OtherOf(string text)
    {
        var (affects, other) = text.Split(' ') switch
        {
            ["swapped", "ends"] => (Affects.Camera, (Func<FormulaProgram, FormulaProgram?>)(program =>
                program.SwapsEnds ? null : program with { SwapsEnds = true })),
            ["scattered", "triangles"] => (Affects.Triangles, program => program.Scatters ? null : program with { Scatters = true }),
            ["moved", var many, "byte" or "bytes"] when int.Parse(many, CultureInfo.InvariantCulture) is var bytes => (Affects.File,
                program => program.MovedBytes != 0 ? null : program with { MovedBytes = bytes }),
            _ => default,
        };
        return other is null ? null : new(null, null, [], []) { Other = other, Affects = affects };
    }

    private static FormatException Unknown(string text) => new($"Mistakes.txt: '{text}' where a step and a formula are expected");
}
