using System.Text;

namespace RayCaster.Benchmarks;

/// <summary>All that was measured, as Markdown.</summary>
internal sealed class Report
{
    public List<RayComparison> Comparisons { get; } = [];

    public List<ProgramComparison> Programs { get; } = [];

    /// <summary>The tables.</summary>
    public string Write(Options options)
    {
        var text = new StringBuilder($"Measured on: {Machine.Description}. {options.Repeats} rounds.\n");
        if (Comparisons.Count > 0)
        {
            text.AppendLine("\n## Rays\n");
            text.AppendLine($"| scene | picture | threads | {string.Join(" | ", Comparisons[0].Own.Select(way => way.Name))} | Embree agrees |");
            text.AppendLine("|---|---|---|--:|--:|--:|--:|--:|--:|");
            foreach (var c in Comparisons)
            {
                var ratios = c.Own.Select(way => c.BestEmbree(way.Answer) is { } best ? Text.Spread(Ratio.Of(way, best)) : "–");
                text.AppendLine($"| {c.Scene.Title} | {c.Size} | {c.Threads} | {string.Join(" | ", ratios)} | {100 * c.Agreement:0.00} % |");
            }
        }
        if (Programs.Count > 0)
        {
            text.AppendLine("\n## Whole processes\n\n| what | quotient | median |\n|---|---|---|");
            foreach (var p in Programs) text.AppendLine($"| {p.What} | {p.Measure} | {Text.Spread(p.Ratio)} |");
        }
        return text.ToString();
    }
}
