using RayCaster.Teaching.Tests.Formulas;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Slips that are not in the catalogue may cost the items of their formulas, and hardly any other.</summary>
public class InnocentItemsTests
{
    [Fact(Explicit = true)]
    [Trait("runs", "weekly")]
    public void AtMostOneOfAHundredItemsIsBlamedInnocently()
    {
        string[][] planted = [.. UnseenSlipsTests.Rows.Select(row => Array.ConvertAll(row.GetData(), cell => $"{cell}"))
            .Where(cells => MarkerTests.two.Scenes.Any(scene => ShowsIn(scene, cells[3])))];
        var (blamed, unnoticed) = (new List<string>(), new List<string>());
        var undecided = 0;
        foreach (var (section, program) in planted.Select(cells => (cells[0], cells[3])))
        {
            var marks = MarkerTests.Mark(MarkerTests.two, scene => ProgramInWords.Draw(scene, program));
            undecided += marks.Items.Count(item => item.Undecided > 0);
            if (marks.Points == 20) unnoticed.Add(program);
            foreach (var item in marks.Items.Where(item => item.Points + item.Undecided < item.Of))
                if (ItemOf(section) != item.Name.Split(' ')[0]) blamed.Add($"{program}: {item.Name}, by {string.Join(' ', item.Because)}");
        }
        Assert.True(planted.Length >= 50, $"only {planted.Length} slips show");
        Assert.True(100 * blamed.Count <= 10 * planted.Length, string.Join('\n', blamed));
        Assert.Empty(unnoticed);
        Assert.True(undecided < 3 * planted.Length, $"{undecided} items are undecided");
    }

    private static bool ShowsIn(MarkedScene scene, string program) =>
        ChangedPixels.Count(ProgramInWords.Draw(scene.Scene, program), scene.Right, levels: 2) >= Rendering.LeastPixels;

    /// <summary>The item of a section of formulas, in docs/rubric.json.</summary>
    private static string ItemOf(string section) => section switch
    {
        "vectors" => "1",
        "plane" => "3",
        "light" or "bytes" => "5",
        "rule" => "6",
        "aabb" => "7",
        "sphere" => "8",
        "circle" => "9",
        "triangle" => "10",
        _ => "4",
    };
}
