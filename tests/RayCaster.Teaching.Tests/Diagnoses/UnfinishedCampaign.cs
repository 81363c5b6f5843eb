using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Diagnoses.UnfinishedTests;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Programs that do not draw everything yet: the pictures are <see cref="EditedLab"/>'s, of scenes from which models were
/// taken.</summary>
public class UnfinishedCampaign
{
    [Theory(Explicit = true)]
    [InlineData("circle,triangle")]
    [InlineData("aabb,circle,triangle")]
    [InlineData("plane")]
    public void WhatElseIsNotDrawnYetIsSaid(string kinds) => new UnfinishedTests().WhatIsNotDrawnYetIsSaidAndNothingElse(kinds);

    [Theory(Explicit = true)]
    [InlineData("aabb", "nohalf")]
    [InlineData("sphere,triangle", "bgr")]
    [InlineData("aabb,circle,triangle", "far-root")]
    public void OtherMistakesOnTopAreNamed(string kinds, string id) => new UnfinishedTests().AMistakeOnTopOfWhatIsThereIsNamed(kinds, id);

    [Fact(Explicit = true)]
    public void AttenuationAloneIsAMistakeOfTheCatalogueToo()
    {
        var diagnosis = Diagnosis.Of(scene, EditedLab.Render(scene, Mistakes.Mistake.Named("att-none")));
        Assert.Equal((Finding.Mistake, "att-none"), (diagnosis.Finding, Assert.Single(diagnosis.Suspects[0].Mistakes).Id));
    }

    [Fact(Explicit = true)]
    public void WhereShapesAreMissingTheTextNamesTheOptionForThoseThatAreWritten()
    {
        var diagnosis = Diagnosis.Of(scene, Drawn("aabb,circle,triangle", "ok"));
        Assert.Contains($"\"diagnose --done {diagnosis.NotYet[0]}\"", DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact(Explicit = true)]
    public void AMistakeThatLosesAShapeIsListedBesideAnother()
    {
        var diagnosis = Diagnosis.Of(scene, MistakeCatalog.Draw(scene, [Named("aspect-none"), Named("box-size")]));
        Assert.Equal((Finding.Mistake, "aspect-none"), (diagnosis.Finding, diagnosis.Suspects[0].Mistakes[0].Id));
        Assert.Contains(diagnosis.Suspects, suspect => suspect.SamePicture
            && suspect.Mistakes.Select(mistake => mistake.Id).Order().SequenceEqual(["aspect-none", "box-size"]));

        static Mistake Named(string id) => MistakeCatalog.Named(id)!;
    }
}
