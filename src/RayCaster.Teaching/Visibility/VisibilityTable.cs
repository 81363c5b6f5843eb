namespace RayCaster.Teaching.Visibility;

/// <summary>The visibility as a table: a line for each model, a column for each outcome that occurs.</summary>
internal static class VisibilityTable
{
    /// <summary>If there are more models, only those with the most hits have a line.</summary>
    private const int MaxLines = 30;

    public static string Format(SceneVisibility visibility)
    {
        var camera = visibility.Scene.Camera;
        var pixels = (long)camera.Width * camera.Height;
        var title = visibility.Rays == pixels
            ? $"What became of {Digits.Count(pixels, "ray")}, model by model:\n"
            : $"What became of the rays, model by model, judged from {Digits.Number(visibility.Rays)} of {Digits.Number(pixels)}:\n";
        if (visibility.Models.Count == 0) return title;

        var byHits = Enumerable.Range(0, visibility.Models.Count).OrderByDescending(i => visibility.Models[i].Hits);
        var shown = byHits.Take(MaxLines).Order().Select(i => visibility.Models[i]).ToArray();
        var columns = Array.FindAll(OutcomeText.All,
            column => column.Outcome == Outcome.Shows || visibility.Models.Any(entry => entry[column.Outcome] > 0));
        var labels = Math.Max("model".Length, shown.Max(entry => entry.Label.Length));
        var width = Math.Max(9, Number(visibility.Rays).Length);
        var lines = shown.Select(entry => Line(entry.Label, columns.Select(column => Number(entry[column.Outcome]))));
        return title + Line("model", columns.Select(column => column.Title)) + string.Concat(lines)
            + (visibility.Models.Count > MaxLines ? $"  and {Digits.Number(visibility.Models.Count - MaxLines)} models with fewer hits\n" : "");

        string Line(string label, IEnumerable<string> cells) =>
            $"  {label.PadRight(labels)}{string.Concat(cells.Select(cell => "  " + cell.PadLeft(width)))}\n";
    }

    private static string Number(long count) => count == 0 ? "-" : Digits.Number(count);
}
