namespace RayCaster.Teaching;

/// <summary>What a mistake affects: it need not be tried on a scene without that.</summary>
[Flags]
internal enum Affects
{
    Camera = 1, // the way from a pixel to its ray: every picture
    Hit = 2, // which crossing counts and which of two hits shows: every picture
    Planes = 4, // the formula of planes, and so on
    Spheres = 8,
    Boxes = 16,
    Circles = 32,
    Triangles = 64, // those of meshes included
    Color = 128, // the way from a hit to three bytes: every picture
    File = 256, // the way from the bytes to the file: every picture
}

/// <summary>Help in three steps: the first ones leave the work to the student.</summary>
/// <param name="Symptom">What one sees.</param>
/// <param name="Question">What to ask oneself.</param>
/// <param name="Answer">What to write instead.</param>
public sealed record Hint(string Symptom, string Question, string Answer);

/// <summary>
/// A mistake that people make in a ray caster, stated as a small change of the slides' formulas: Mistakes.txt has them all. A program may have
/// several.
/// </summary>
public sealed class Mistake
{
    /// <summary>What affects every picture, whatever shapes are in it.</summary>
    internal const Affects WholePicture = Affects.Camera | Affects.Hit | Affects.Color | Affects.File;

    private readonly List<Mistake> variants = [];
    private readonly Func<FormulaProgram, FormulaProgram?> change;

    /// <param name="changes">What people write; the first that fits a scene counts.</param>
    internal Mistake(string id, string slide, string cause, Hint hint, IReadOnlyList<WrittenChange> changes, bool isWithinRounding)
        : this(id, AffectedBy(changes), slide, cause, hint, In(changes)) => IsWithinRounding = isWithinRounding;

    internal Mistake(string id, Affects affects, string slide, string cause, Hint hint, Func<FormulaProgram, FormulaProgram?> change)
    {
        (Id, Affects, Slide, Cause, Hint, this.change) = (id, affects, slide, cause, hint, change);
        variants.Add(this);
    }

    /// <summary>A short name without blanks, the same for ever.</summary>
    public string Id { get; }

    /// <summary>What is wrong in the program, in one line.</summary>
    public string Cause { get; }

    /// <summary>The title of the slide with the right formula; docs/slides-to-code.md names its code.</summary>
    public string Slide { get; }

    /// <summary>Help in three steps.</summary>
    public Hint Hint { get; }

    internal Affects Affects { get; private set; }

    /// <summary>Where it is, if it is a small edit of the slides' formulas that the catalogue does not have; its id is "edit".</summary>
    public EditPlace? Place { get; internal init; }

    /// <summary>The same mistake as different people write it: one id, but a cause for each. This one is the first.</summary>
    public IReadOnlyList<Mistake> Variants => variants;

    /// <summary>Whether it changes channels by at most a level, like rounding, so it makes no pixel wrong.</summary>
    internal bool IsWithinRounding { get; }

    /// <summary>A program with the mistake; null if it has another of the same part of a formula.</summary>
    internal FormulaProgram? In(FormulaProgram program) => change(program);

    /// <summary>Whether a scene has what the mistake affects; if not, its picture is right.</summary>
    public bool Touches(Scene scene) => Touches(scene.Models.Select(model => model.Kind));

    /// <summary>Whether the mistake affects programs that draw these kinds of shape, by their names in scene files.</summary>
    public bool Touches(IEnumerable<string> kinds) => (Affects & WholePicture) != 0 || kinds.Any(kind => (Affects & KindOf(kind)) != 0);

    /// <summary>Its id.</summary>
    public override string ToString() => Id;

    /// <summary>Adds a variant: another place where the same mistake is made.</summary>
    internal void Or(string cause, IReadOnlyList<WrittenChange> changes)
    {
        Affects |= AffectedBy(changes);
        foreach (var variant in variants) variant.Affects = Affects;
        variants.Add(Worded(cause, In(changes)));
    }

    /// <summary>The same mistake with another cause and another change of a program.</summary>
    internal Mistake Worded(string cause, Func<FormulaProgram, FormulaProgram?> other) => new(Id, Affects, Slide, cause, Hint, other);

    internal static Affects KindOf(Model model) => KindOf(model.Kind);

    /// <summary>The formula of a kind of shape, by its name in scene files.</summary>
    internal static Affects KindOf(string kind) => ShapeKind.Of(kind)?.Formula ?? 0;

    /// <summary>What is affected by a change of a step's formulas.</summary>
    internal static Affects AffectedBy(SectionKind step) => step switch
    {
        SectionKind.Vectors or SectionKind.Camera or SectionKind.Sample or SectionKind.Pixel => Affects.Camera,
        SectionKind.File => Affects.File,
        SectionKind.Rule or SectionKind.Nearest => Affects.Hit,
        SectionKind.Light or SectionKind.Bytes => Affects.Color,
        _ => KindOf(step.ToString().ToLowerInvariant()),
    };

    private static Func<FormulaProgram, FormulaProgram?> In(IReadOnlyList<WrittenChange> changes) =>
        program => changes.Select(change => change.In(program)).FirstOrDefault(changed => changed is not null);

    /// <summary>What the formulas are for; a rule of some shapes is for these. A style affects nothing.</summary>
    private static Affects AffectedBy(IReadOnlyList<WrittenChange> changes)
    {
        var steps = changes[0].Steps;
        if (steps.Any(step => !step.Shapes.IsEmpty))
            return steps.SelectMany(step => step.Shapes).Aggregate((Affects)0, (all, shape) => all | AffectedBy(shape));
        return steps.Where(step => step.Kind is null || !step.Written.IsEmpty).Aggregate((Affects)0, (all, step) => all | step.Affects);
    }
}
