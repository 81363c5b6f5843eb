using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Slips that the catalogue does not have: the diagnosis says in which formula they are, or names none.</summary>
public class UnseenSlipsTests
{
    private static readonly string[] scenes = ["mistakes/generic", "mistakes/portrait", "mistakes/inside"];

    /// <summary>The slips that are not named.</summary>
    private static readonly string[] unnamed =
    [
    ];

    public static IEnumerable<TheoryDataRow<int, string>> Rows => UnseenSlips.All.Select((slip, i) => new TheoryDataRow<int, string>(i, slip.What));

    [Theory(Explicit = true)]
    [Trait("runs", "weekly")]
    [MemberData(nameof(Rows))]
    public void ASlipIsNamedInItsStepOrNotAtAll(int place, string what)
    {
        var slip = UnseenSlips.All[place];
        var (scene, picture) = Shown(slip, place);
        var diagnosis = Diagnosis.Of(scene, picture);
        var named = diagnosis.Finding == Finding.Mistake ? diagnosis.Suspects[0].Mistakes : [];
        var step = Mistake.AffectedBy(Enum.Parse<SectionKind>(slip.Section, ignoreCase: true));
        Assert.All(named, mistake => Assert.NotEqual(default, mistake.Affects & step));
        Assert.Equal(unnamed.Contains(what) ? 0 : 1, named.Count);
    }

    [Fact]
    public void ThePageSaysHowManyAreNamed()
    {
        var page = File.ReadAllText(ProjectFolder.PathOf("src/RayCaster.Teaching/Diagnoses/README.md")).ReplaceLineEndings(" ");
        var (all, not) = (UnseenSlips.All.Length, unnamed.Length);
        Assert.Equal(60, all);
        Assert.Matches(@$"sixty slips [^:]*: {all - not} are named by their formula or their mistake, none by another, {not} not at all", page);
    }

    [Theory]
    [InlineData("plane", "Camera", "Width - w / 2", "Width - w / 4", "pixel", "uc", "uc = w·c / width − w / 2")]
    [InlineData("first", "Sphere", "Sqrt(R * R - D * D)", "Sqrt(2 * R * R - D * D)", "sphere", "t_hc", "t_hc = √(R² − D²)", Explicit = true)]
    public void OnlyTheAnswerTellsTheFormulaOfASlip(
        string name, string file, string old, string @new, string section, string step, string formula)
    {
        var scene = SceneFolder.Small(name, 16);
        var diagnosis = Diagnosis.Of(scene, EditedLab.Render(scene, PlantedMistake.Of(new SourceEdit(file, old, @new))));
        var mistake = Assert.Single(Assert.Single(diagnosis.Suspects).Mistakes);
        Assert.Equal(("edit", new EditPlace(section, step, formula)), (mistake.Id, mistake.Place));
        Assert.DoesNotContain(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"), StringComparison.Ordinal);
        Assert.Contains(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json", HintLevel.Answer), StringComparison.Ordinal);
    }

    /// <summary>A scene that shows a slip, and the picture; they take turns.</summary>
    private static (Scene Scene, Picture Picture) Shown(UnseenSlips.Slip slip, int turn)
    {
        for (var k = 0; ; k++)
        {
            var scene = SceneFolder.Small(scenes[(turn + k) % scenes.Length]);
            var picture = EditedLab.Render(scene, PlantedMistake.Of(slip.Edits));
            if (k == scenes.Length || ChangedPixels.Count(picture, EditedLab.Render(scene), levels: 2) >= SceneFitness.LeastPixels)
                return (scene, picture);
        }
    }
}
