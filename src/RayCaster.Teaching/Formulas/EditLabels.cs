namespace RayCaster.Teaching;

/// <summary>Which edits are known by name. The first line of Mistakes.txt that fits an edit counts.</summary>
internal static class EditLabels
{
    /// <summary>The id of an edit that fits a pattern; null if none does.</summary>
    public static string? IdOf(FormulaEdit edit) => MistakeBook.Labels.FirstOrDefault(label => label.Step is { } step
        && step.Kind == edit.Section.Kind && (step.Style is null || step.Style == edit.Section.Style) && Fits(edit, label))?.Id;

    /// <summary>The formulas that have a label, in a section, and what they change in others.</summary>
    public static IEnumerable<(string Id, StepChange.Written Step, ImmutableArray<FormulaSection> Beside)> FormulasFor(FormulaSection section) =>
        from label in MistakeBook.Labels
        where label.Written.Length > 0 && label.Written.All(step => step is StepChange.Written { Shapes.IsEmpty: true })
        let first = (StepChange.Written)label.Written[0]
        where first.Kind == section.Kind && !first.Formulas.IsEmpty
            && (first.Style is not null ? first.Style == section.Style
                : section.Kind == SectionKind.Rule ? section.Style != "aim"
                : section.Kind == SectionKind.Sample || section == FormulaBook.Slides.StylesOf(section.Kind)[0])
        select (label.Id, first, label.Written.Skip(1).Cast<StepChange.Written>().Select(SectionOf).ToImmutableArray());

    internal static bool Fits(FormulaEdit edit, MistakeBook.Label label) =>
        (label.Operators.Length == 0 || label.Operators.Contains(edit.Operator)) && label.Subjects.Any(subject =>
            subject == edit.Meant || subject == edit.Formula?.Computed || subject == ComponentOf(edit)
            || (subject.EndsWith('*') && edit.Meant.StartsWith(subject[..^1], StringComparison.Ordinal)));

    private static FormulaSection SectionOf(StepChange.Written step)
    {
        var styles = FormulaBook.Slides.StylesOf(step.Kind);
        return step.In(styles.FirstOrDefault(section => section.Style == step.Style) ?? styles[0]);
    }

    /// <summary>The first component in which an edited vector (x, y, z) differs, as "cross.y"; null for other edits.</summary>
    private static string? ComponentOf(FormulaEdit edit)
    {
        if (edit.Formula is not { Right: { Operator: Operator.Vector } right } formula) return null;
        if (edit.Section.Formulas[edit.Place!.Value].Right is not { Operator: Operator.Vector } written) return null;
        var place = Enumerable.Range(0, 3).FirstOrDefault(i => written.Operands[i].ToString() != right.Operands[i].ToString());
        return $"{formula.Computed}.{"xyz"[place]}";
    }
}
