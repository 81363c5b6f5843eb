namespace RayCaster.Teaching;

/// <summary>Which edits are known by name: the lines of Labels.txt. The first line that fits an edit counts.</summary>
internal static class EditLabels
{
    /// <summary>A line: either formulas that people write, or a pattern.</summary>
    /// <param name="Style">The only style in which it counts; null for each.</param>
    /// <param name="Written">A formula or several at once, each as name = expression; empty for a pattern.</param>
    /// <param name="Subjects">A pattern's formulas by name, or parts of them; a * at the end is for any text.</param>
    /// <param name="Operators">A pattern's operators; any if empty.</param>
    internal sealed record Label(string Id, SectionKind Kind, string? Style, (string Name, string Right)[] Written, string[] Subjects,
        EditOperator[] Operators);

    /// <summary>All lines, in their order.</summary>
    public static IReadOnlyList<Label> All { get; } = [.. Read(FormulaBook.TextOf("Labels.txt"))];

    /// <summary>The id of an edit that fits a pattern; null if none does.</summary>
    public static string? IdOf(FormulaEdit edit) => All.FirstOrDefault(label => label.Written.Length == 0 && label.Kind == edit.Section.Kind
        && (label.Style is null || label.Style == edit.Section.Style) && Fits(edit, label))?.Id;

    /// <summary>The formulas that have a label, in a section: some at once.</summary>
    public static IEnumerable<(string Id, (string Name, string Right)[] Written)> FormulasFor(FormulaSection section) =>
        from label in All
        where label.Written.Length > 0 && label.Kind == section.Kind
            && (label.Style ?? FormulaBook.Slides.StylesOf(section.Kind)[0].Style) == section.Style
        select (label.Id, label.Written);

    internal static bool Fits(FormulaEdit edit, Label label) =>
        (label.Operators.Length == 0 || label.Operators.Contains(edit.Operator)) && label.Subjects.Any(subject =>
            subject == edit.Meant || subject == edit.Formula?.Computed || subject == ComponentOf(edit)
            || (subject.EndsWith('*') && edit.Meant.StartsWith(subject[..^1], StringComparison.Ordinal)));

    /// <summary>The first component in which an edited vector (x, y, z) differs, as "cross.y"; null for other edits.</summary>
    private static string? ComponentOf(FormulaEdit edit)
    {
        if (edit.Formula is not { Right: { Operator: Operator.Vector } right } formula) return null;
        if (edit.Section.Formulas[edit.Place!.Value].Right is not { Operator: Operator.Vector } written) return null;
        var place = Enumerable.Range(0, 3).FirstOrDefault(i => written.Operands[i].ToString() != right.Operands[i].ToString());
        return $"{formula.Computed}.{"xyz"[place]}";
    }

    private static IEnumerable<Label> Read(string text)
    {
        var id = "";
        foreach (var line in text.Split('\n').Select(line => line.Trim()).Where(line => line.Length > 0 && line[0] != '#'))
        {
            if (line[0] == '[')
            {
                id = line.Trim('[', ']');
                continue;
            }
            var (step, rest) = line.Split(' ', 2) is [var first, var second] ? (first.Split('/'), second) : throw Unknown(line);
            if (!Enum.TryParse<SectionKind>(step[0], ignoreCase: true, out var kind)) throw Unknown(line);
            var style = step.Length > 1 ? step[1] : null;
            var isPattern = rest.Split(": ") is { Length: 2 } || rest.EndsWith(':');
            if (isPattern)
            {
                var parts = rest.Split(':', StringSplitOptions.TrimEntries);
                yield return new(id, kind, style, [], parts[0].Split(" | "),
                    [.. parts[1].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(Enum.Parse<EditOperator>)]);
                continue;
            }
            foreach (var alternative in Alternatives(rest)) yield return new(id, kind, style, alternative, [], []);
        }
    }

    /// <summary>"a = 1 | 2" is "a = 1" or "a = 2"; "a = 1; b = 2" is both at once.</summary>
    private static IEnumerable<(string Name, string Right)[]> Alternatives(string text)
    {
        var name = "";
        foreach (var alternative in text.Split(" | "))
        {
            yield return
            [
                .. alternative.Split("; ").Select(formula =>
                {
                    if (formula.Split(" = ") is [var own, var right]) return (name = own, right);
                    return (name, formula);
                }),
            ];
        }
    }

    private static FormatException Unknown(string line) => new($"Labels.txt: '{line}' where a step and a formula are expected");
}
