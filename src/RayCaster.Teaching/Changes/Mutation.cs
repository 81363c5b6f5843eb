namespace RayCaster.Teaching.Changes;

/// <summary>A small edit of a step.</summary>
/// <param name="Step">The step with the edit.</param>
/// <param name="Place">Which of its formulas is edited; the first, if the same slip is in several; null if it is in all of them.</param>
/// <param name="Meant">What should have been written instead of <paramref name="Written"/>.</param>
/// <param name="Cost">The less, the likelier people make it.</param>
internal sealed record Mutation(Step Step, int? Place, string Meant, string Written, MutationOperator Operator, double Cost)
{
    /// <summary>The id of the known mistake that it is; null if it is none.</summary>
    public string? Label { get; init; }

    /// <summary>Other right styles of other steps, beside which the edit shows.</summary>
    public ImmutableArray<Step> Beside { get; init; } = [];

    /// <summary>The unedited step.</summary>
    public Step Right => FormulaBook.Slides[Step.Kind, Step.Style];

    /// <summary>The formula that is edited, as the slides have it; null if the slip is in all.</summary>
    public Formula? Formula => Place is { } place ? Right.Formulas[place] : null;

    public override string ToString() => $"{Step.Name}: {Formula?.ToString() ?? "everywhere"}: {Written} for {Meant} ({Operator})";
}
