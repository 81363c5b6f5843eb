
namespace RayCaster.Teaching.Tests.Changes;

/// <summary>Programs that do not draw everything yet: the pictures are <see cref="EditedLab"/>'s, of scenes from which models were
/// taken.</summary>
public class MissingPartTests
{
    private static readonly Scene scene = DiagnosisTests.scene;

    [Fact]
    public void AttenuationAloneIsAMistakeOfTheCatalogueToo()
    {
        var first = SceneFolder.Small("first", 8);
        var diagnosis = DiagnosisResult.Find(first, EditedLab.Render(first, PlantedMistake.Named("att-none")), new());
        Assert.Equal((DiagnosisKind.Mistake, "att-none"), (diagnosis.Kind, Assert.Single(diagnosis.Suspects[0].Mistakes).Id));
        Assert.Equal([MissingPart.Attenuation], diagnosis.MissingParts);
        var text = DiagnosisReport.Text(diagnosis, "mine.png", "scene.json").ReplaceLineEndings("\n");
        Assert.Contains("Not drawn yet: attenuation. The rest is right.\nIf that is written already, most likely:\n", text);
        Assert.DoesNotContain("--done", text);
    }

    [Fact]
    public void WhatIsNotWrittenYetIsNotListedAsAMistakeBesideAnother()
    {
        var plane = SceneFolder.Small("plane", 8);
        var picture = ProgramInWords.Draw(plane, "formulas w-sign & formulas att-none & formulas no-znear & formulas no-zfar");
        var text = DiagnosisReport.Text(DiagnosisResult.Find(plane, picture, new()), "mine.png", "scene.json").ReplaceLineEndings("\n");
        Assert.Contains("Not drawn yet: attenuation, clipping.\nMost likely:\n  Symptom:", text);
        Assert.DoesNotContain("zNear", text);
    }

    [Fact]
    public void WhatIsDoneIsNotTakenForMissing()
    {
        var picture = ProgramInWords.Draw(scene, "without sphere");
        Assert.Equal(["sphere"], new Diagnoser(scene).Diagnose(picture).MissingParts);
        var diagnosis = new Diagnoser(scene).Diagnose(picture, ["sphere", "plane"]);
        Assert.DoesNotContain("sphere", diagnosis.MissingParts);
    }

    [Fact]
    public void APreparedSceneJudgesManyPicturesLikeOne()
    {
        var prepared = new Diagnoser(scene);
        foreach (var id in new[] { "ok", "rows" })
        {
            var picture = ProgramInWords.Draw(scene, id);
            var (one, other) = (prepared.Diagnose(picture), DiagnosisTests.OfPlanted(id));
            Assert.Equal(DiagnosisReport.Json(other, default, default, [], null), DiagnosisReport.Json(one, default, default, [], null));
        }
    }

    [Fact(Explicit = true)]
    public void AMistakeThatLosesAShapeIsListedBesideAnother()
    {
        var diagnosis = DiagnosisResult.Find(scene, ProgramInWords.Draw(scene, "formulas aspect-none & formulas box-size"), new());
        Assert.Equal((DiagnosisKind.Mistake, "aspect-none"), (diagnosis.Kind, diagnosis.Suspects[0].Mistakes[0].Id));
        Assert.Contains(diagnosis.Suspects, suspect => suspect.SamePicture
            && suspect.Mistakes.Select(mistake => mistake.Id).Order().SequenceEqual(["aspect-none", "box-size"]));
    }
}
