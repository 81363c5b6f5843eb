using RayCaster.Teaching.Tests.Mistakes;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Programs that do not draw everything yet: the pictures are <see cref="EditedLab"/>'s, of scenes from which models were
/// taken.</summary>
public class UnfinishedTests
{
    internal static readonly Scene scene = SceneFolder.Small("mistakes/generic", 4);

    [Theory]
    [InlineData("aabb")]
    [InlineData("plane,sphere")]
    [InlineData("sphere,aabb,circle,triangle")]
    public void WhatIsNotDrawnYetIsSaidAndNothingElse(string kinds)
    {
        var diagnosis = Diagnosis.Of(scene, Drawn(kinds, "ok"));
        Assert.Equal((Finding.Unfinished, kinds), (diagnosis.Finding, InOrder(diagnosis, kinds)));
        Assert.Contains("The rest is right.", DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact]
    public void NoAttenuationIsNotDrawnYetEither()
    {
        var diagnosis = Diagnosis.Of(scene, Drawn("circle,triangle", "att-none"));
        Assert.Equal((Finding.Unfinished, "circle,triangle,attenuation"), (diagnosis.Finding, InOrder(diagnosis, "circle,triangle,attenuation")));
    }

    [Fact]
    public void AttenuationAloneIsAMistakeOfTheCatalogueToo()
    {
        var first = SceneFolder.Small("first", 8);
        var diagnosis = Diagnosis.Of(first, EditedLab.Render(first, Mistakes.Mistake.Named("att-none")));
        Assert.Equal((Finding.Mistake, "att-none"), (diagnosis.Finding, Assert.Single(diagnosis.Suspects[0].Mistakes).Id));
        Assert.Equal([Diagnosis.Attenuation], diagnosis.NotYet);
        var text = DiagnosisReport.Text(diagnosis, "mine.png", "scene.json").ReplaceLineEndings("\n");
        Assert.Contains("Not drawn yet: attenuation. The rest is right.\nIf that is written already, most likely: att-none\n", text);
        Assert.DoesNotContain("--done", text);
    }

    [Fact]
    public void WhatIsNotWrittenYetIsNotListedAsAMistakeBesideAnother()
    {
        var plane = SceneFolder.Small("plane", 8);
        var picture = MistakeCatalog.Draw(plane,
            [.. new[] { "w-sign", "att-none", "no-znear", "no-zfar" }.Select(id => MistakeCatalog.Named(id)!)]);
        var text = DiagnosisReport.Text(Diagnosis.Of(plane, picture), "mine.png", "scene.json").ReplaceLineEndings("\n");
        Assert.Contains("Not drawn yet: attenuation, clipping.\nMost likely: w-sign\n  Symptom:", text);
        Assert.DoesNotContain("zNear", text);
    }

    [Theory]
    [InlineData("circle,triangle", "rows")]
    public void AMistakeOnTopOfWhatIsThereIsNamed(string kinds, string id)
    {
        var diagnosis = Diagnosis.Of(scene, Drawn(kinds, id));
        Assert.Equal((Finding.Mistake, kinds), (diagnosis.Finding, InOrder(diagnosis, kinds)));
        Assert.Equal(id, Assert.Single(diagnosis.Suspects[0].Mistakes).Id);
        Assert.Contains($"\"diagnose --done {diagnosis.NotYet[0]}\"", DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact]
    public void WhatIsDoneIsNotTakenForMissing()
    {
        var picture = Drawn("sphere", "ok");
        Assert.Equal(["sphere"], new SceneDiagnosis(scene).Judge(picture).NotYet);
        var diagnosis = new SceneDiagnosis(scene).Judge(picture, ["sphere", "plane"]);
        Assert.DoesNotContain("sphere", diagnosis.NotYet);
    }

    [Fact]
    public void TheWeekOfBoxesTellsUnsortedParametersFromBoxesThatAreNotWritten()
    {
        var boxes = SceneFolder.Small("weeks/3-boxes", 4);
        var diagnosis = Diagnosis.Of(boxes, EditedLab.Render(boxes, Mistakes.Mistake.Named("slab-noswap")));
        Assert.Equal((Finding.Mistake, "slab-noswap"), (diagnosis.Finding, Assert.Single(diagnosis.Suspects[0].Mistakes).Id));
        Assert.Empty(diagnosis.Suspects[0].Twins);
    }

    [Fact]
    public void APreparedSceneJudgesManyPicturesLikeOne()
    {
        var prepared = new SceneDiagnosis(scene);
        foreach (var id in new[] { "ok", "rows" })
        {
            var picture = Drawn("", id);
            var (one, other) = (prepared.Judge(picture), DiagnosisTests.OfPlanted(id));
            Assert.Equal(DiagnosisReport.Json(other, default, default, [], null), DiagnosisReport.Json(one, default, default, [], null));
        }
    }

    /// <summary>What a program draws that leaves kinds of shape out.</summary>
    internal static Picture Drawn(string kinds, string mistake)
    {
        var without = scene with { Models = [.. scene.Models.Where(model => !kinds.Split(',').Contains(model.Kind))] };
        return EditedLab.Render(without, Mistakes.Mistake.Named(mistake));
    }

    /// <summary>What is not drawn yet, in the order of an expectation.</summary>
    private static string InOrder(Diagnosis diagnosis, string expected) =>
        string.Join(',', diagnosis.NotYet.OrderBy(part => Array.IndexOf(expected.Split(','), part)));
}
