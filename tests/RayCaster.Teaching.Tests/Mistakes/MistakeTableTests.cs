using System.Globalization;

namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>docs/mistakes-table.md tells what each mistake changes; this keeps it true. RAYCASTER_ACCEPT=1 writes it anew.</summary>
public class MistakeTableTests
{
    /// <summary>Differences that the eye sees.</summary>
    internal const int VisibleLevels = 2;

    private static readonly string file = ProjectFolder.PathOf("docs/mistakes-table.md");
    private static readonly string[] scenes = [.. SceneFolder.Files("scenes/mistakes")];

    [Fact]
    [Trait("kind", "campaign")]
    public void TheTableInTheDocsIsTrue()
    {
        var table = Table();
        if (Environment.GetEnvironmentVariable("RAYCASTER_ACCEPT") == "1") Write(table);

        var written = File.ReadAllLines(file).Where(line => line.StartsWith('|')).ToArray();
        Assert.Equal(table.Length, written.Length);
        Assert.All(table.Zip(written), pair =>
            Assert.True(Agree(pair.First, pair.Second), $"is    {pair.First}\nwas   {pair.Second}"));
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

    /// <summary>Equal but for a few pixels that the last bits of another machine's tangent may turn.</summary>
    private static bool Agree(string a, string b)
    {
        var (left, right) = (a.Split(" | "), b.Split(" | "));
        return left.Length == right.Length && left.Zip(right).All(pair => pair.First == pair.Second ||
            Math.Abs(Number(pair.First) - Number(pair.Second)) <= 0.2);
    }

    private static double Number(string cell) =>
        double.TryParse(cell.TrimEnd(' ', '|'), NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number : double.NaN;

    private static void Write(string[] table)
    {
        var kept = File.ReadAllLines(file).TakeWhile(line => !line.StartsWith('|'));
        File.WriteAllText(file, string.Join('\n', kept.Concat(table)) + "\n");
    }
}
