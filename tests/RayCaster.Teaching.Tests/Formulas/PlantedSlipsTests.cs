namespace RayCaster.Teaching.Tests.Formulas;

/// <summary>Slips that the catalogue does not have: the diagnosis says in which formula they are.</summary>
public class PlantedSlipsTests
{
    [Theory]
    [InlineData("t_hc = √(2 R² − D²)", "sphere", "t_hc", "t_hc = √(R² − D2)")]
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
        var scene = SceneFolder.Small(name, 4);
        return Diagnosis.Of(scene, new PlantedSlips(scene, slip).Draw());
    }
}
