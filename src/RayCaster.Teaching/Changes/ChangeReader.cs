namespace RayCaster.Teaching.Changes;

/// <summary>Reads what people write, as Mistakes.txt has it after "is" and in further wordings.</summary>
internal static class ChangeReader
{
    /// <summary>What "some" shapes are: each kind, the solid ones, the flat ones.</summary>
    private static readonly ImmutableArray<StepKind>[] some =
    [
        .. ShapeKind.Basic.Select(shape => (ImmutableArray<StepKind>)[shape.Step]), [StepKind.Sphere, StepKind.Aabb],
        [StepKind.Plane, StepKind.Circle, StepKind.Triangle],
    ];

    /// <summary>A line, whose parts each begin with a step, but for further formulas of the step before them.</summary>
    /// <returns>Several, if shapes or styles are to be tried one by one.</returns>
    public static IEnumerable<ImmutableArray<StepChange>> Read(string line)
    {
        List<List<string>> steps = [];
        foreach (var part in line.Split("; "))
        {
            if (UnsaidOf(part) is null && !part.StartsWith("for ", StringComparison.Ordinal) && KindOf(part.Split(' ', '/')[0]) is null)
                (steps.Count > 0 ? steps[^1] : throw Unknown(part)).Add(part);
            else steps.Add([part]);
        }
        return steps.Aggregate((IEnumerable<ImmutableArray<StepChange>>)[[]], (all, step) =>
            from before in all from choice in ReadStep(step[0], step[1..]) select before.Add(choice));
    }

    /// <summary>Reads "for SHAPES STEP/STYLE NAME = EXPRESSION", all but the step left out, or what no formula says.</summary>
    public static IReadOnlyList<StepChange> ReadStep(string text, params List<string> more)
    {
        if (UnsaidOf(text) is { } unsaid) return [unsaid];
        var words = text.Split(' ');
        ImmutableArray<StepKind>[] shapes = [[]];
        if (words[0] == "for")
        {
            shapes = words[1] == "some" ? some : [[.. words[1].Split('+').Select(word => KindOf(word) ?? throw Unknown(text))]];
            words = words[2..];
        }
        var step = words[0].Split('/');
        var kind = KindOf(step[0]) ?? throw Unknown(text);
        if (words.Length > 1) more = [string.Join(' ', words[1..]), .. more];
        ImmutableArray<(string, string)> formulas = [.. more.Select(FormulaOf)];
        return
        [
            .. from style in step.Length > 1 ? step[1].Split('|') : (string?[])[null]
               from own in shapes
               select new StepChange.Written(kind, style, own, formulas),
        ];
    }

    private static (string Name, string Right) FormulaOf(string written) =>
        written.StartsWith("hits ", StringComparison.Ordinal) ? ("hits", written[5..])
        : written.Split(" = ") is [var name, var right] ? (name, right) : throw Unknown(written);

    private static StepKind? KindOf(string word) => Enum.TryParse<StepKind>(word, ignoreCase: true, out var kind) ? kind : null;

    private static StepChange? UnsaidOf(string text) => text.Split(' ') switch
    {
        ["swapped", "ends"] => new StepChange.SwappedEyeAndTarget(),
        ["scattered", "triangles"] => new StepChange.NoisyTriangles(),
        ["moved", var many, "byte" or "bytes"] => new StepChange.ByteShift(int.Parse(many, CultureInfo.InvariantCulture)),
        _ => null,
    };

    private static FormatException Unknown(string text) => new($"Mistakes.txt: '{text}' where a step and a formula are expected");
}
