namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Slips that the catalogue does not have (UnseenSlips.txt): the diagnosis says in which formula they are, or names none.</summary>
public class UnseenSlipsTests
{
    private static readonly string[] scenes = ["mistakes/generic", "mistakes/portrait", "mistakes/inside"];

    public static ITheoryDataRow[] Rows { get; } = [.. TestTable.Read("Formulas/UnseenSlips.txt")];

    [Theory(Explicit = true)]
    [Trait("runs", "weekly")]
    [MemberData(nameof(Rows))]
    public void ASlipIsNamedInItsStepOrNotAtAll(string section, string formulas, string whether, string program)
    {
        var (scene, picture) = Shown(program, Array.FindIndex(Rows, row => row.GetData()[3] is string other && other == program));
        var diagnosis = DiagnosisResult.Find(scene, picture, new());
        Change[] named = diagnosis.Kind == DiagnosisKind.Mistake ? [.. diagnosis.Suspects[0].Mistakes] : [];
        Assert.Equal((whether, named.Length), (named.Length > 0 ? "named" : "-", Math.Min(1, named.Length)));
        var step = Enum.GetValues<StepKind>().First(kind => kind.InWords() == section);
        Assert.All(named, mistake => Assert.True(mistake.Steps.Any(own => own == step || (own.IsOfRays() && step.IsOfRays())
            || (own.IsOfHits() && step.IsOfHits()) || (own.IsOfColors() && step.IsOfColors())) && (mistake.Place is not { } place
            || formulas.Split(' ').Contains(place.Name)), $"{mistake.Id}: {mistake.Place} {mistake.Cause}"));
    }

    [Fact]
    public void ThePageSaysHowManyAreNamed()
    {
        var page = File.ReadAllText(ProjectFolder.PathOf("src/RayCaster.Teaching/Diagnosis/README.md")).ReplaceLineEndings(" ");
        var named = Rows.Count(row => row.GetData()[2] is "named");
        Assert.Equal(60, Rows.Length);
        Assert.Contains($"{named} are named by their formula or their mistake, none by another, {60 - named} not at all", page);
    }

    [Theory]
    [InlineData("plane", "Camera: Width - w / 2 → Width - w / 4", "pixel", "uc", "uc = w·c / width − w / 2")]
    [InlineData("first", "Sphere: Sqrt(R * R - D * D) → Sqrt(2 * R * R - D * D)", "sphere", "t_hc", "t_hc = √(R² − D²)", Explicit = true)]
    public void OnlyTheAnswerTellsTheFormulaOfASlip(string name, string program, string section, string step, string formula)
    {
        var scene = SceneFolder.Small(name, 16);
        var diagnosis = DiagnosisResult.Find(scene, ProgramInWords.Draw(scene, program), new());
        var mistake = Assert.Single(Assert.Single(diagnosis.Suspects).Mistakes);
        Assert.Equal(("edit", section, step, formula), (mistake.Id, mistake.Place?.Step, mistake.Place?.Name, mistake.Place?.Formula));
        Assert.DoesNotContain(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"), StringComparison.Ordinal);
        Assert.Contains(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json", HintLevel.Answer), StringComparison.Ordinal);
    }

    /// <summary>A scene that shows a slip, and the picture; they take turns.</summary>
    private static (Scene Scene, Picture Picture) Shown(string program, int turn)
    {
        for (var k = 0; ; k++)
        {
            var scene = SceneFolder.Small(scenes[(turn + k) % scenes.Length]);
            var picture = ProgramInWords.Draw(scene, program);
            if (k == scenes.Length || ChangedPixels.Count(picture, EditedLab.Render(scene), levels: 2) >= Rendering.LeastPixels)
                return (scene, picture);
        }
    }
}
