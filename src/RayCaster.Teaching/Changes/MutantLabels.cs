namespace RayCaster.Teaching.Changes;

/// <summary>Which edits are known by name. The first line of Mistakes.txt that fits an edit counts.</summary>
internal static class MutantLabels
{
    /// <summary>The id of an edit that fits a pattern; null if none does.</summary>
    public static string? IdOf(Mutant mutant) => MistakeBook.Labels.FirstOrDefault(label => label.Step is { } step
        && step.Kind == mutant.Section.Kind && (step.Style is null || step.Style == mutant.Section.Style) && Fits(mutant, label))?.Id;

    /// <summary>The formulas that have a label, in a section, and what they change in others.</summary>
    public static IEnumerable<(string Id, StepChange.Written Step, ImmutableArray<Step> Beside)> FormulasFor(Step section) =>
        from label in MistakeBook.Labels
        where label.Written.Length > 0 && label.Written.All(step => step is StepChange.Written { Shapes.IsEmpty: true })
        let first = (StepChange.Written)label.Written[0]
        where first.Kind == section.Kind && !first.Formulas.IsEmpty
            && (first.Style is not null ? first.Style == section.Style
                : section.Kind == StepKind.Rule ? section.Style != "aim"
                : section.Kind == StepKind.Sample || section == FormulaBook.Slides.StylesOf(section.Kind)[0])
        select (label.Id, first, label.Written.Skip(1).Cast<StepChange.Written>().Select(SectionOf).ToImmutableArray());

    internal static bool Fits(Mutant mutant, MistakeBook.Label label) =>
        (label.Operators.Length == 0 || label.Operators.Contains(mutant.Operator)) && label.Subjects.Any(subject =>
            subject == mutant.Meant || subject == mutant.Formula?.Computed || subject == ComponentOf(mutant)
            || (subject.EndsWith('*') && mutant.Meant.StartsWith(subject[..^1], StringComparison.Ordinal)));

    private static Step SectionOf(StepChange.Written step)
    {
        var styles = FormulaBook.Slides.StylesOf(step.Kind);
        return step.In(styles.FirstOrDefault(section => section.Style == step.Style) ?? styles[0]);
    }

    /// <summary>The first component in which an edited vector (x, y, z) differs, as "cross.y"; null for other edits.</summary>
    private static string? ComponentOf(Mutant mutant)
    {
        if (mutant.Formula is not { Right: { Operator: Operator.Vector } right } formula) return null;
        if (mutant.Section.Formulas[mutant.Place!.Value].Right is not { Operator: Operator.Vector } written) return null;
        var place = Enumerable.Range(0, 3).FirstOrDefault(i => written.Operands[i].ToString() != right.Operands[i].ToString());
        return $"{formula.Computed}.{"xyz"[place]}";
    }
}
