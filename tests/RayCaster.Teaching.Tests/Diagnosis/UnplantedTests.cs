using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Tests.Diagnosis;

/// <summary>What is said of pictures with mistakes that nobody planted: Unplanted/Unplanted.txt. A wrong name is worse than none, and a sentence
/// never contradicts what the same picture proves.</summary>
public partial class UnplantedTests
{
    private const string Folder = "Diagnosis/Unplanted";

    public static IEnumerable<ITheoryDataRow> Rows => TestTable.Read($"{Folder}/Unplanted.txt");

    public static IEnumerable<object[]> AllRows => Rows.Select(row => row.GetData()!)!;

    [Theory]
    [MemberData(nameof(Rows))]
    public void NoNameIsWrong(string picture, string scene, string edit, string says, string never, string compared)
    {
        _ = (edit, compared); // for draw.py, and for the other test
        var (judged, mine) = Read(picture, scene);
        var said = Blanks().Replace(DiagnosisReport.Text(DiagnosisResult.Find(judged, mine, new SearchBudget()), "mine.png", "scene.json"), " ");
        Assert.Contains(says, said, StringComparison.Ordinal);
        Assert.All(never.Split("; "), other => Assert.DoesNotContain(other, said, StringComparison.Ordinal));
    }

    [Theory]
    [MemberData(nameof(AllRows))]
    public void TheComparisonAgrees(string picture, string scene, string edit, string says, string never, string compared)
    {
        _ = (edit, says, never);
        var (judged, mine) = Read(picture, scene);
        Assert.Contains(compared, ComparisonText.Format(new(mine, Renderer.Render(judged), judged), "mine.png", "right.png"),
                StringComparison.Ordinal);
    }

    private static (Scene Scene, Picture Mine) Read(string picture, string scene)
    {
        var folder = ProjectFolder.PathOf($"tests/RayCaster.Teaching.Tests/{Folder}");
        return (SceneFolder.Read(Path.Combine(folder, scene + ".json")), PictureFile.Read(Path.Combine(folder, picture + ".png")));
    }

    [GeneratedRegex(@"\s+")]
    private static partial Regex Blanks();
}
