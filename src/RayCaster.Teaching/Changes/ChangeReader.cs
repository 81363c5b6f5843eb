namespace RayCaster.Teaching.Changes;

/// <summary>Reads what people write, as Mistakes.txt has it after "is" and in further wordings.</summary>
internal static class ChangeReader
{
    /// <summary>What "some" shapes are: each kind, the solid ones, the flat ones.</summary>
    private static readonly StepKind[][] some =
    [
        .. ShapeKind.Basic.Select(shape => (StepKind[])[shape.Step]), [StepKind.Sphere, StepKind.Aabb],
        [StepKind.Plane, StepKind.Circle, StepKind.Triangle],
    ];

    /// <summary>A line, whose parts each begin with a step, but for further formulas of the step before them. "for SHAPES" before them names the
    /// kinds of shape whose rule is meant.</summary>
    /// <returns>Several, if shapes or styles are to be tried one by one.</returns>
    public static IEnumerable<StepChange[]> Read(string line)
    {
        if (line.Split(' ', 3) is ["for", var shapes, var rest])
            return (shapes == "some" ? some : [ShapesOf(shapes, line)]).SelectMany(own => Read(rest, own));
        return Read(line, []);
    }

    private static IEnumerable<StepChange[]> Read(string line, StepKind[] shapes)
    {
        List<List<string>> steps = [];
        foreach (var part in line.Split("; "))
        {
            if (UnsaidOf(part) is null && KindsOf(part.Split(' ', '/')[0]).Length == 0)
                (steps.Count > 0 ? steps[^1] : throw Unknown(part)).Add(part);
            else steps.Add([part]);
        }
        return steps.Aggregate((IEnumerable<StepChange[]>)[[]], (all, step) =>
            from before in all from choice in ReadStep(step[0], step[1..], shapes) select (StepChange[])[.. before, .. choice]);
    }

    /// <summary>Reads "STEP/STYLE NAME = EXPRESSION", all but the step left out, or what no formula says. "rule" and "sample" are two
    /// steps.</summary>
    private static IEnumerable<StepChange[]> ReadStep(string text, List<string> more, StepKind[] shapes)
    {
        if (UnsaidOf(text) is { } unsaid) return [[unsaid]];
        var (first, formula) = text.Split(' ', 2) is [var one, var two] ? (one, two) : (text, null);
        var step = first.Split('/');
        ImmutableArray<(string, string)> formulas = [.. (formula is null ? more : more.Prepend(formula)).Select(FormulaOf)];
        return (step.Length > 1 ? step[1].Split('|') : (string?[])[null]).Select(style => KindsOf(step[0]).Select(kind =>
            new StepChange.Written(kind, style, kind is StepKind.Depth or StepKind.Distance ? [.. shapes] : [], formulas)).ToArray<StepChange>());
    }

    private static (string Name, string Right) FormulaOf(string written) =>
        written.StartsWith("hits ", StringComparison.Ordinal) ? ("hits", written[5..])
        : written.Split(" = ") is [var name, var right] ? (name, right) : throw Unknown(written);

    private static StepKind[] KindsOf(string word) =>
        [.. Enum.GetValues<StepKind>().Where(kind => kind.InWords() == word || kind.ToString().Equals(word, StringComparison.OrdinalIgnoreCase))];

    private static StepChange? UnsaidOf(string text) => text.Split(' ') switch
    {
        ["swapped", "ends"] => new StepChange.SwappedEyeAndTarget(),
        ["scattered", "triangles"] => new StepChange.NoisyTriangles(),
        ["moved", var many, "byte" or "bytes"] => new StepChange.ByteShift(int.Parse(many, CultureInfo.InvariantCulture)),
        _ => null,
    };

    private static StepKind[] ShapesOf(string words, string line) =>
        [.. words.Split('+').SelectMany(word => KindsOf(word) is [_, ..] kinds ? kinds : throw Unknown(line))];

    private static FormatException Unknown(string text) => new($"Mistakes.txt: '{text}' where a step and a formula are expected");
}
