using System.Text;

namespace RayCaster.Benchmarks;

/// <summary>All that was measured, as Markdown.</summary>
internal sealed class Report
{
    public List<RayComparison> Comparisons { get; } = [];

    public List<ProgramComparison> Programs { get; } = [];

    /// <summary>The tables.</summary>
    public string Write(Options options, TimeSpan elapsed)
    {
        var text = new StringBuilder();
        text.AppendLine($"Measured on: {Machine.Description}. {options.Repeats} rounds; " +
            $"the whole run took {Math.Ceiling(elapsed.TotalMinutes):0} minutes.");
        if (Comparisons.Count > 0) WriteRays(text);
        if (Programs.Count > 0) WritePrograms(text);
        return text.ToString();
    }

    private void WriteRays(StringBuilder text)
    {
        text.AppendLine("\n## Rays\n");
        text.AppendLine("| scene | picture | threads | exact t | bytes | exact t, later frame | bytes, later frame | bytes of a single picture | " +
            "scalar definition | naive, struct | naive, class | Embree agrees | its build / its trace |");
        text.AppendLine("|---|---|---|---|---|---|---|---|---|---|---|---|---|");
        foreach (var c in Comparisons)
        {
            var cells = new List<string> { c.Scene.Title, c.Size, $"{c.Threads}" };
            cells.AddRange(new[] { c.Exact, c.Bytes, c.LaterExact, c.LaterBytes, c.SinglePicture }.Select(way => Against(c, way, Text.Spread)));
            cells.AddRange(new[] { c.Scalar, c.NaiveStruct, c.NaiveClass }.Select(way => Against(c, way, ratio => Text.Ratio(ratio.Median))));
            cells.Add(double.IsNaN(c.Agreement) ? "–" : $"{100 * c.Agreement:0.00} %");
            cells.Add(Text.Ratio(c.BuildPerTrace));
            text.AppendLine($"| {string.Join(" | ", cells)} |");
        }

        var embree = Comparisons.Where(c => c.BestEmbree(Answer.Hits) is not null).ToList();
        if (embree.Count > 0)
        {
            text.AppendLine("\nEmbree's best way, of those tried:\n\n| scene | picture | threads | for t and model | for bytes |\n" +
                "|---|---|---|---|---|");
            foreach (var c in embree)
                text.AppendLine($"| {c.Scene.Title} | {c.Size} | {c.Threads} | {c.BestEmbree(Answer.Hits)!.Name} | " +
                    $"{c.BestEmbree(Answer.Bytes)!.Name} |");
        }

        var pairs = from all in Comparisons
                    from one in Comparisons
                    where one.Threads == 1 && all.Threads > 1 && one.Scene == all.Scene && one.Size == all.Size
                    select (one, all);
        if (!pairs.Any()) return;
        text.AppendLine("\nTimes as fast as one thread:\n\n| scene | picture | threads | exact t | bytes | Embree, t and model | Embree, bytes |\n" +
            "|---|---|---|---|---|---|---|");
        foreach (var (one, all) in pairs)
        {
            Func<RayComparison, Way?>[] ways = [c => c.Exact, c => c.Bytes, c => c.BestEmbree(Answer.Hits), c => c.BestEmbree(Answer.Bytes)];
            var cells = ways.Select(way => way(one) is { } slow && way(all) is { } fast ? Text.Ratio(slow.Median / fast.Median) : "–");
            text.AppendLine($"| {all.Scene.Title} | {all.Size} | {all.Threads} | {string.Join(" | ", cells)} |");
        }
    }

    private static string Against(RayComparison c, Way? way, Func<Ratio, string> write) =>
        way is not null && c.BestEmbree(way.Answer) is { } best ? write(Ratio.Of(way, best)) : "–";

    private void WritePrograms(StringBuilder text)
    {
        text.AppendLine("\n## Whole processes\n\n| what | quotient | median |\n|---|---|---|");
        foreach (var p in Programs) text.AppendLine($"| {p.What} | {p.Measure} | {Text.Spread(p.Ratio)} |");
    }
}
