namespace RayCaster.Teaching.Changes;

/// <summary>
/// What somebody may have written in a program: a mistake of the catalogue in one of its ways, a slip that has no name, a part that is not written
/// yet, or another right style.
/// </summary>
public sealed record Change
{
    /// <summary>The id of all slips that are not in the catalogue.</summary>
    public const string NoName = "edit";

    internal Change(ImmutableArray<StepChange> ofSteps, double bits) => (OfSteps, Bits) = (ofSteps, bits);

    /// <summary>What it does to a program.</summary>
    internal ImmutableArray<StepChange> OfSteps { get; }

    /// <summary>The less, the likelier.</summary>
    internal double Bits { get; init; }

    /// <summary>What is wrong in the program, in one line; empty for what is no mistake.</summary>
    public string Cause { get; internal init; } = "";

    /// <summary>The mistake of the catalogue; null for others.</summary>
    public Mistake? Mistake { get; internal init; }

    /// <summary>Whether it is what most people write who make its mistake.</summary>
    public bool IsUsual { get; internal init; }

    /// <summary>The slip of a formula; null for others.</summary>
    internal Mutation? Mutation { get; init; }

    /// <summary>What is not written yet: a kind of shape, attenuation or clipping; null for others.</summary>
    internal string? MissingPart { get; init; }

    /// <summary>Where it is, if it is a slip that the catalogue does not have.</summary>
    public FormulaPlace? Place { get; internal init; }

    /// <summary>The mistake that a slip resembles, though its picture is another, so that its question may not fit.</summary>
    public Mistake? Similar { get; internal init; }

    /// <summary>Help in three steps; empty for what is no mistake.</summary>
    public Hint Hint { get => field ?? Mistake?.Hint ?? new("", "", ""); internal init; }

    /// <summary>The id of its mistake; <see cref="NoName"/> for a slip without one, empty for what is no mistake.</summary>
    public string Id => Mistake?.Id ?? (Mutation is null ? "" : Mutation.Label ?? NoName);

    /// <summary>The title of the slide with the right formula; empty for what is no mistake.</summary>
    public string Slide => Mistake?.Slide ?? Mutation?.Step.Slide ?? "";

    /// <summary>The steps whose formulas are changed: by any way of its mistake, or by the slip.</summary>
    internal IReadOnlySet<StepKind> Steps => Mistake?.Steps ?? OwnSteps.ToHashSet();

    /// <summary>The steps whose formulas it changes itself; where it is a rule of some kinds of shape, these shapes alone.</summary>
    internal IEnumerable<StepKind> OwnSteps =>
        OfSteps.OfType<StepChange.Written>().Where(step => !step.Shapes.IsEmpty).ToArray() is { Length: > 0 } rules
            ? rules.SelectMany(rule => rule.Shapes) : OfSteps.SelectMany(step => step.Steps);

    internal bool IsOtherSample => Mistake?.IsOtherSample == true;

    /// <summary>Whether it counts as a mistake; rays through the other sample point are none beside one.</summary>
    internal bool IsMistake => Id != "" && !IsOtherSample;

    /// <summary>Whether its mistake, or the slip, changes the formulas of a kind of shape, and nothing else.</summary>
    public bool IsOnlyOf(string kind) => ShapeKind.Find(kind) is { } shape && Steps.SetEquals([shape.Step]);

    /// <summary>The kinds of shape whose formulas it changes in the slides' program, by their names in scene files.</summary>
    public IEnumerable<string> ChangedShapes => In(FormulaProgram.Slides) is { } program
        ? ShapeKind.All.Where(kind => program.ChangedShapes.Any(shape => shape.Step == kind.Step)).Select(kind => kind.Name) : [];

    /// <summary>A program with it; null if the program has a change of the same part of a formula, or if it does not fit.</summary>
    internal FormulaProgram? In(FormulaProgram program) =>
        OfSteps.Aggregate((FormulaProgram?)program, (all, step) => all is null ? null : step.In(all));

    /// <summary>Its id.</summary>
    public override string ToString() => Id;
}
