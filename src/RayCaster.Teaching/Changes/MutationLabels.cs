namespace RayCaster.Teaching.Changes;

/// <summary>Which edits are known by name. The first line of Mistakes.txt that fits an edit counts.</summary>
internal static class MutationLabels
{
    /// <summary>The id of an edit that fits a pattern; null if none does.</summary>
    public static string? IdOf(Mutation mutation) => MistakeBook.Labels.FirstOrDefault(label => label.Step is { } step
        && step.Kind == mutation.Step.Kind && (step.Style is null || step.Style == mutation.Step.Style) && Fits(mutation, label))?.Id;

    /// <summary>The formulas that have a label, in a step, and what they change in others.</summary>
    public static IEnumerable<(string Id, StepChange.Written Step, ImmutableArray<Step> Beside)> FormulasFor(Step step) =>
        from label in MistakeBook.Labels
        where label.Written.Length > 0 && label.Written.All(step => step is StepChange.Written { Shapes.IsEmpty: true })
        let written = label.Written.Cast<StepChange.Written>() // but for the scenes that need the other rule
            .Where(own => own.Kind == step.Kind || own.Kind.InWords() != step.Kind.InWords()).ToArray()
        let first = written.FirstOrDefault()
        where first?.Kind == step.Kind && !first!.Formulas.IsEmpty
            && (first.Style is not null ? first.Style == step.Style : step == FormulaBook.Slides.StylesOf(step.Kind)[0])
        select (label.Id, first, written.Skip(1).Select(StepOf).ToImmutableArray());

    internal static bool Fits(Mutation mutation, MistakeBook.Label label) =>
        (label.Operators.Length == 0 || label.Operators.Contains(mutation.Operator)) && label.Subjects.Any(subject =>
            subject == mutation.Meant || subject == mutation.Formula?.Computed || subject == ComponentOf(mutation)
            || (subject.EndsWith('*') && mutation.Meant.StartsWith(subject[..^1], StringComparison.Ordinal)));

    private static Step StepOf(StepChange.Written step)
    {
        var styles = FormulaBook.Slides.StylesOf(step.Kind);
        return step.In(styles.FirstOrDefault(style => style.Style == step.Style) ?? styles[0]);
    }

    /// <summary>The first component in which an edited vector (x, y, z) differs, as "cross.y"; null for other edits.</summary>
    private static string? ComponentOf(Mutation mutation)
    {
        if (mutation.Formula is not { Right: { Operator: Operator.Vector } right } formula) return null;
        if (mutation.Step.Formulas[mutation.Place!.Value].Right is not { Operator: Operator.Vector } written) return null;
        var place = Enumerable.Range(0, 3).FirstOrDefault(i => written.Operands[i].ToString() != right.Operands[i].ToString());
        return $"{formula.Computed}.{"xyz"[place]}";
    }
}
