namespace RayCaster.Teaching.Comparison;

/// <summary>Whole lines and columns that have one colour and should not: no loop reached them.</summary>
internal sealed class UnreachedLines
{
    /// <summary>How many colours are tried, the most frequent of the wrong pixels first.</summary>
    private const int Colors = 3;

    /// <summary>How many runs of lines are named.</summary>
    private const int MaxRuns = 4;

    private readonly HashSet<int> lines, columns;
    private readonly string words;

    private UnreachedLines(int[] lines, int[] columns, (byte, byte, byte) color, Picture picture)
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

    /// <summary>Finds them; null if there are none, or if hardly anything else is there.</summary>
    public static UnreachedLines? Find(PictureDifference difference)
    {
        var (mine, wrong) = (difference.Mine, Enumerable.Range(0, difference.Pixels).Where(difference.IsWrong));
        if (mine.IsNearlyOneColor) return null;
        foreach (var (color, _) in wrong.CountBy(mine.At).OrderByDescending(color => color.Value).Take(Colors))
        {
            var lines = Whole(mine.Height, mine.Width, (along, across) => across * mine.Width + along);
            var columns = Whole(mine.Width, mine.Height, (along, across) => along * mine.Width + across);
            if (lines.Length + columns.Length > 0 && 4 * lines.Length <= 3 * mine.Height && 4 * columns.Length <= 3 * mine.Width)
                return new(lines, columns, color, mine);

            int[] Whole(int count, int length, Func<int, int, int> place) =>
            [
                .. Enumerable.Range(0, count).Where(across => Enumerable.Range(0, length).All(along => mine.At(place(along, across)) == color)
                    && Enumerable.Range(0, length).Any(along => difference.IsWrong(place(along, across)))),
            ];
        }
        return null;
    }

    /// <summary>The explanation of a picture that is right but for them; null if it is not.</summary>
    public static Explanation? Explain(PictureDifference difference, PictureJudge judge)
    {
        if (Find(difference) is not { } found) return null;
        var (mine, right) = (difference.Mine, difference.Reference);
        var rest = Picture.Create(mine.Width, mine.Height, (x, y) => found.Contains(x, y) ? right[x, y] : mine[x, y]);
        return judge.Judge(rest) == Likeness.Wrong ? null : new(Way.Places, found.Sentence, found.Bits);
    }

    /// <summary>What they cost: by chance a formula draws lines of the background, or of what lies behind.</summary>
    public double Bits => (Color.R == Color.G && Color.G == Color.B ? Priors.Lines : Priors.LinesOfAnyColor) + Math.Min(6, Runs - 1);

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
