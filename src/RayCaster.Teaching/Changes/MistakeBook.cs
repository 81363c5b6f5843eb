namespace RayCaster.Teaching.Changes;

/// <summary>Mistakes.txt, line by line.</summary>
internal static class MistakeBook
{
    /// <summary>A further wording of a mistake: formulas, or a pattern.</summary>
    /// <param name="Id">Empty for a formula without a name.</param>
    /// <param name="Step">The step of a pattern; null for formulas.</param>
    /// <param name="Written">The formulas; none for a pattern.</param>
    /// <param name="Subjects">A pattern's formulas by name, or parts of them; a * at the end is for any text.</param>
    /// <param name="Operators">A pattern's operators; any if empty.</param>
    internal sealed record Label(
        string Id, StepChange.Written? Step, StepChange[] Written, string[] Subjects, MutationOperator[] Operators);

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
            var words = new Dictionary<string, string>();
            List<Change> changes = [];
            var cause = "";
            foreach (var line in lines.Skip(1))
            {
                var (word, rest) = line.Split(' ', 2) is [var first, var second] ? (first, second) : (line, "");
                switch (word)
                {
                    case "slide" or "symptom" or "question" or "answer" or "rounding" or "rare" or "missing" or "hidden": words[word] = rest; break;
                    case "cause" or "or": cause = rest; break;
                    case "is":
                        foreach (var way in ChangeReader.Read(rest))
                        {
                            var own = cause.Replace("some shapes", ShapesOf(way), StringComparison.Ordinal);
                            changes.Add(new([.. way], Priors.Known) { Cause = own });
                            labels.Add(new(id, null, way, [], []));
                        }
                        break;
                    default: labels.AddRange(LabelsOf(id, line)); break;
                }
            }
            if (id != "")
                mistakes.Add(new(id, words["slide"], new(words["symptom"], words["question"], words["answer"]), words, changes));
        }
        return (mistakes, labels);
    }

    /// <summary>The kinds of shape that a way's first step is for, in words.</summary>
    private static string ShapesOf(StepChange[] way)
    {
        string[] words = way[0] is StepChange.Written { Shapes: var shapes } ? [.. shapes.Select(shape => ShapeKind.Find(shape).Many)] : [];
        return words.Length > 1 ? $"{string.Join(", ", words[..^1])} and {words[^1]}" : string.Concat(words);
    }

    private static IEnumerable<Label> LabelsOf(string id, string line)
    {
        if (!line.Contains(" = ", StringComparison.Ordinal) && line.LastIndexOf(':') is > 0 and var colon)
        {
            var (step, subjects) = line[..colon].Split(' ', 2) is [var first, var second] ? (first, second) : (line, "");
            MutationOperator[] operators =
                [.. line[(colon + 1)..].Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(name => MutationBook.Slips[name])];
            return ChangeReader.Read(step).SelectMany(steps => steps).Select(pattern =>
                new Label(id, (StepChange.Written)pattern, [], subjects.Split(" | "), operators));
        }
        return Alternatives(line).SelectMany(ChangeReader.Read).Select(way => new Label(id, null, way, [], []));
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
