namespace RayCaster.Teaching.Formulas;

/// <summary>Whole lines and columns that have one colour and should not: no loop reached them.</summary>
internal sealed class UnreachedLines
{
    /// <summary>How many runs of lines are named.</summary>
    private const int MaxRuns = 4;

    private readonly HashSet<int> lines, columns;
    private readonly string words;

    /// <param name="picture">The picture that has them.</param>
    public UnreachedLines(int[] lines, int[] columns, (byte, byte, byte) color, Picture picture)
    {
        (this.lines, this.columns, Color) = ([.. lines], [.. columns], color);
        words = string.Join(" and ", ((string?[])[Words(lines, picture.Height, "line"), Words(columns, picture.Width, "column")]).OfType<string>());
        Runs = RunsOf(lines).Count() + RunsOf(columns).Count();
    }

    /// <summary>The colour that they have.</summary>
    public (byte R, byte G, byte B) Color { get; }

    /// <summary>How many groups of neighbours they are.</summary>
    public int Runs { get; }

    /// <summary>Which they are, and a question.</summary>
    public string Sentence => $"{char.ToUpperInvariant(words[0])}{words[1..]} {(lines.Count + columns.Count == 1 ? "is" : "are")} {Color}: " +
        $"does your loop reach {(lines.Count + columns.Count == 1 ? "it" : "them")}?";

    /// <summary>Whether a pixel is in one of them.</summary>
    public bool Contains(int x, int y) => lines.Contains(y) || columns.Contains(x);

    private static string? Words(int[] some, int count, string what)
    {
        if (some.Length == 0) return null;
        if (some is [var only]) return only == 0 ? $"the first {what}" : only == count - 1 ? $"the last {what}" : $"the {what} {only}{From(what)}";
        var runs = RunsOf(some).ToArray();
        if (runs is [var (first, last)])
            return first == 0 ? $"the first {some.Length} {what}s" : last == count - 1 ? $"the last {some.Length} {what}s"
                : $"the {what}s {first} to {last}{From(what)}";
        if (runs is [(0, var top), (var bottom, var end)] && end == count - 1)
            return top == 0 && bottom == end ? $"the first and the last {what}" : $"the first {top + 1} and the last {count - bottom} {what}s";
        var named = runs.Take(MaxRuns).Select(run => run.First == run.Last ? $"{run.First}" : $"{run.First} to {run.Last}");
        return $"the {what}s {string.Join(", ", named)}{(runs.Length > MaxRuns ? " …" : "")}{From(what)}";
    }

    private static string From(string what) => what == "line" ? " from the top" : "";

    private static IEnumerable<(int First, int Last)> RunsOf(int[] some)
    {
        for (var i = 0; i < some.Length; i++)
        {
            var first = some[i];
            while (i + 1 < some.Length && some[i + 1] == some[i] + 1) i++;
            yield return (first, some[i]);
        }
    }
}
