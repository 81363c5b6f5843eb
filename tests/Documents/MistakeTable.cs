using System.Globalization;
using RayCaster.Teaching.Tests.Mistakes;
using Mistake = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Documents;

/// <summary>docs/mistakes-table.md, which says how much of each picture a mistake changes.</summary>
internal static class MistakeTable
{
    /// <summary>Differences that the eye sees.</summary>
    public const int VisibleLevels = 2;

    public static string File { get; } = ProjectFolder.PathOf("docs/mistakes-table.md");

    private static readonly string[] scenes = [.. SceneFolder.Files("scenes/mistakes")];

    /// <summary>The page with the table, which stays as it is where it is still true.</summary>
    public static string Text()
    {
        var (table, lines) = (Table(), System.IO.File.ReadAllLines(File));
        var written = lines.Where(line => line.StartsWith('|')).ToArray();
        var isTrue = table.Length == written.Length && table.Zip(written).All(pair => Agree(pair.First, pair.Second));
        return string.Join('\n', isTrue ? lines : lines.TakeWhile(line => !line.StartsWith('|')).Concat(table)) + "\n";
    }

    /// <summary>A head of two lines and a line for each mistake: its name, what it is, what share of each picture it changes.</summary>
    private static string[] Table()
    {
        var read = scenes.Select(SceneFolder.Read).ToArray();
        var right = read.Select(scene => EditedLab.Render(scene, Mistake.None)).ToArray();
        string Share(int scene, Mistake mistake)
        {
            var camera = read[scene].Camera;
            var count = ChangedPixels.Count(right[scene], EditedLab.Render(read[scene], mistake), VisibleLevels);
            return count == 0 ? "–" : (100.0 * count / (camera.Width * camera.Height)).ToString("0.0", CultureInfo.InvariantCulture);
        }
        return
        [
            Line(["mistake", "what is wrong", .. scenes.Select(Path.GetFileNameWithoutExtension)!]),
            Line(["---", "---", .. scenes.Select(_ => "--:")]),
            .. Mistake.All.Select(mistake =>
                Line([$"`{mistake.Id}`", Escape(mistake.What), .. scenes.Select((_, i) => Share(i, mistake))])),
        ];
    }

    private static string Line(string[] cells) => $"| {string.Join(" | ", cells)} |";

    private static string Escape(string text) => text.Replace("|", "\\|");

    /// <summary>Equal except for a few pixels that may change with the last bits of another machine's tangent.</summary>
    private static bool Agree(string a, string b)
    {
        var (left, right) = (a.Split(" | "), b.Split(" | "));
        return left.Length == right.Length && left.Zip(right).All(pair => pair.First == pair.Second ||
            Math.Abs(Number(pair.First) - Number(pair.Second)) <= 0.2);
    }

    private static double Number(string cell) =>
        double.TryParse(cell.TrimEnd(' ', '|'), NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number : double.NaN;
}
