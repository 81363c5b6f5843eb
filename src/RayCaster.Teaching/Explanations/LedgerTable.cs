using System.Globalization;
using System.Text;

namespace RayCaster.Teaching;

/// <summary>The ledger as a table: a line for each model, a column for each outcome that occurs.</summary>
internal static class LedgerTable
{
    /// <summary>If there are more models, only those with the most hits have a line.</summary>
    private const int MostLines = 30;

    private static readonly (Outcome Outcome, string Title)[] Columns =
    [
        (Outcome.Shows, "shows"),
        (Outcome.Hidden, "hidden"),
        (Outcome.Behind, "behind"),
        (Outcome.UnderBias, "t <= bias"),
        (Outcome.BeforeNear, "z < zNear"),
        (Outcome.BeyondFar, "z > zFar"),
        (Outcome.Outside, "outside"),
        (Outcome.PassesBy, "passes by"),
        (Outcome.Parallel, "along it"),
        (Outcome.NoNumber, "no number"),
    ];

    public static void Write(HitLedger ledger, StringBuilder text)
    {
        var camera = ledger.Scene.Camera;
        var pixels = (long)camera.Width * camera.Height;
        text.Append(ledger.Rays == pixels
            ? Text($"What became of {pixels:N0} rays, model by model:\n")
            : Text($"What became of the rays, model by model, judged from {ledger.Rays:N0} of {pixels:N0}:\n"));
        if (ledger.Models.Count == 0) return;

        var byHits = Enumerable.Range(0, ledger.Models.Count).OrderByDescending(i => ledger.Models[i].Hits);
        var shown = byHits.Take(MostLines).Order().Select(i => ledger.Models[i]).ToArray();
        var columns = Array.FindAll(Columns,
            column => column.Outcome == Outcome.Shows || ledger.Models.Any(entry => entry[column.Outcome] > 0));
        var labels = Math.Max("model".Length, shown.Max(entry => entry.Label.Length));
        var width = Math.Max(9, Text($"{ledger.Rays:N0}").Length);

        text.Append("  ").Append("model".PadRight(labels));
        foreach (var column in columns) text.Append("  ").Append(column.Title.PadLeft(width));
        text.Append('\n');
        foreach (var entry in shown)
        {
            text.Append("  ").Append(entry.Label.PadRight(labels));
            foreach (var column in columns)
            {
                var count = entry[column.Outcome];
                text.Append("  ").Append((count == 0 ? "-" : Text($"{count:N0}")).PadLeft(width));
            }
            text.Append('\n');
        }
        if (ledger.Models.Count > MostLines) text.Append(Text($"  and {ledger.Models.Count - MostLines:N0} models with fewer hits\n"));
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
