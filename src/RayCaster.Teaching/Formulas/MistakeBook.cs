namespace RayCaster.Teaching;

/// <summary>Mistakes.txt, line by line.</summary>
internal static class MistakeBook
{
    /// <summary>A further wording of a mistake: formulas, or a pattern.</summary>
    /// <param name="Id">Empty for a formula without a name.</param>
    /// <param name="Step">The step of a pattern; null for formulas.</param>
    /// <param name="Written">The formulas; null for a pattern.</param>
    /// <param name="Subjects">A pattern's formulas by name, or parts of them; a * at the end is for any text.</param>
    /// <param name="Operators">A pattern's operators; any if empty.</param>
    internal sealed record Label(string Id, WrittenStep? Step, WrittenChange? Written, string[] Subjects, EditOperator[] Operators);

    private static readonly Lazy<(List<Mistake> Mistakes, List<Label> Labels)> read = new(() => Read(FormulaBook.TextOf("Mistakes.txt")));

    /// <summary>All mistakes, in their order.</summary>
    public static IReadOnlyList<Mistake> Mistakes => read.Value.Mistakes;

    /// <summary>All formulas and patterns, in their order.</summary>
    public static IReadOnlyList<Label> Labels => read.Value.Labels;

    private static (List<Mistake>, List<Label>) Read(string text)
    {
        List<Mistake> mistakes = [];
        List<Label> labels = [];
        foreach (var block in text.Split("\n[").Skip(1))
        {
            var lines = block.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
            var id = lines[0].TrimEnd(']');
            var facts = new Dictionary<string, string>();
            List<(string Cause, List<WrittenChange> Changes)> variants = [];
            var cause = "";
            foreach (var line in lines.Skip(1))
            {
                var (word, rest) = line.Split(' ', 2) is [var first, var second] ? (first, second) : (line, "");
                switch (word)
                {
                    case "slide" or "symptom" or "question" or "answer" or "rounding": facts[word] = rest; break;
                    case "cause" or "or": cause = rest; break;
                    case "is":
                        foreach (var change in WrittenChange.Read(rest))
                        {
                            var own = cause.Replace("some shapes", change.ShapesInWords, StringComparison.Ordinal);
                            var alike = variants.Find(variant => variant.Cause == own && change.IsForAnotherSceneThan(variant.Changes[^1]));
                            if (alike.Changes is not null) alike.Changes.Add(change);
                            else variants.Add((own, [change]));
                            labels.Add(new(id, null, change, [], []));
                        }
                        break;
                    default: labels.AddRange(LabelsOf(id, line)); break;
                }
            }
            if (id == "") continue;
            var mistake = new Mistake(id, facts["slide"], variants[0].Cause, new(facts["symptom"], facts["question"], facts["answer"]),
                variants[0].Changes, facts.ContainsKey("rounding"));
            foreach (var (other, changes) in variants.Skip(1)) mistake.Or(other, changes);
            mistakes.Add(mistake);
        }
        return (mistakes, labels);
    }

    private static IEnumerable<Label> LabelsOf(string id, string line)
    {
        if (!line.Contains(" = ", StringComparison.Ordinal) && line.LastIndexOf(':') is > 0 and var colon)
        {
            var (step, subjects) = line[..colon].Split(' ', 2) is [var first, var second] ? (first, second) : (line, "");
            return [new(id, WrittenStep.Read(step).Step, null, subjects.Split(" | "),
                [.. line[(colon + 1)..].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(Enum.Parse<EditOperator>)])];
        }
        return Alternatives(line).SelectMany(WrittenChange.Read).Select(change => new Label(id, null, change, [], []));
    }

    /// <summary>The alternatives of a line of formulas: one without a step has that of the line, one without a name that of the one before.
    /// </summary>
    private static IEnumerable<string> Alternatives(string line)
    {
        var step = line.Split(' ', 2)[0];
        var name = "";
        foreach (var alternative in line[(step.Length + 1)..].Split(" | "))
        {
            var full = alternative.Split("; ")[0].Contains(" = ", StringComparison.Ordinal) ? alternative : $"{name} = {alternative}";
            name = full.Split("; ")[^1].Split(" = ")[0];
            yield return $"{step} {full}";
        }
    }
}
