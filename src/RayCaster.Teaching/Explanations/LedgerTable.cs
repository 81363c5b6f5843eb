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

        var order = new int[ledger.Models.Count];
        for (var i = 0; i < order.Length; i++) order[i] = i;
        if (order.Length > MostLines)
        {
            Array.Sort(order, (a, b) => (-ledger.Models[a].Hits, a).CompareTo((-ledger.Models[b].Hits, b)));
            Array.Sort(order, 0, MostLines);
        }
        var shown = order.AsSpan(0, Math.Min(MostLines, order.Length));

        var columns = Array.FindAll(Columns, column => column.Outcome == Outcome.Shows || Occurs(ledger, column.Outcome));
        var labels = "model".Length;
        foreach (var i in shown) labels = Math.Max(labels, ledger.Models[i].Label.Length);
        var width = Math.Max(9, Text($"{ledger.Rays:N0}").Length);

        text.Append("  ").Append("model".PadRight(labels));
        foreach (var column in columns) text.Append("  ").Append(column.Title.PadLeft(width));
        text.Append('\n');
        foreach (var i in shown)
        {
            text.Append("  ").Append(ledger.Models[i].Label.PadRight(labels));
            foreach (var column in columns)
            {
                var count = ledger.Models[i][column.Outcome];
                text.Append("  ").Append((count == 0 ? "-" : Text($"{count:N0}")).PadLeft(width));
            }
            text.Append('\n');
        }
        if (order.Length > MostLines) text.Append(Text($"  and {order.Length - MostLines:N0} models with fewer hits\n"));
    }

    private static bool Occurs(HitLedger ledger, Outcome outcome)
    {
        foreach (var entry in ledger.Models)
            if (entry[outcome] > 0)
                return true;
        return false;
    }

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
