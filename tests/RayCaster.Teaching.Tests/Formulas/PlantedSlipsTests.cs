using Xunit.Abstractions;

namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Slips that the catalogue does not have: the diagnosis says in which step they are.</summary>
public class PlantedSlipsTests(ITestOutputHelper output)
{
    private static readonly string[] scenes = ["mistakes/generic", "mistakes/portrait", "mistakes/inside"];

    [Fact]
    [Trait("kind", "campaign")]
    public void MostSlipsAreFoundInTheirStep()
    {
        var (shown, right, none) = (0, 0, 0);
        for (var i = 0; i < PlantedSlips.All.Length; i++)
        {
            var (section, _, what) = PlantedSlips.All[i];
            var diagnosis = Diagnose(scenes[i % scenes.Length], i);
            var named = diagnosis.Suspects.FirstOrDefault()?.Mistakes[0];
            output.WriteLine($"{diagnosis.Finding}\t{section}: {what}\t{named?.Id} {named?.Place}");
            if (diagnosis.Finding is not (Finding.Mistake or Finding.NoneOfThese)) continue; // it does not show, or a shape is lost
            shown++;
            if (named is null) none++;
            else if ((named.Concerns & EditNaming.ConcernsOf(Enum.Parse<SectionKind>(section, ignoreCase: true))) != 0) right++;
        }
        output.WriteLine($"{right} of {shown} in the right step, {none} not named");
        Assert.InRange(right, 0.9 * shown, shown);
        Assert.InRange(none, 0, 0.05 * shown);
    }

    [Theory]
    [InlineData("thc = √(2 R² − D²)", "sphere", "thc", "thc = √(R² − D2)")]
    [InlineData("C − B for C − A", "triangle", "e2", "e2 = C − A")]
    [InlineData("uc = w c / width − w / 4", "pixel", "uc", "uc = w·c / width − w / 2")]
    public void ASlipIsFoundInItsFormula(string what, string section, string step, string formula)
    {
        var diagnosis = Diagnose("mistakes/generic", Array.FindIndex(PlantedSlips.All, slip => slip.What == what));
        var mistake = Assert.Single(Assert.Single(diagnosis.Suspects).Mistakes);
        Assert.Equal(("edit", new EditPlace(section, step, formula)), (mistake.Id, mistake.Place));
        Assert.DoesNotContain(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"), StringComparison.Ordinal);
        Assert.Contains(formula, DiagnosisReport.Text(diagnosis, "mine.png", "scene.json", HintLevel.Answer), StringComparison.Ordinal);
    }

    [Fact]
    public void WithoutASlipThePictureIsRight() => Assert.Equal(Finding.Matches, Diagnose("mistakes/generic", -1).Finding);

    private static Diagnosis Diagnose(string name, int slip)
    {
        var scene = SceneFolder.Small(name);
        return Diagnosis.Of(scene, new PlantedSlips(scene, slip).Draw());
    }
}
