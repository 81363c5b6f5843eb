using RayCaster.Teaching.Tests.Mistakes;
using static RayCaster.Teaching.Tests.Diagnoses.DiagnosisTests;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>The wrong pictures are <see cref="EditedLab"/>'s.</summary>
public class DiagnosisCampaign
{
    [Fact(Explicit = true)]
    public void AFewPixelsThatNobodyWouldSeeThereDoNotMatch()
    {
        var picture = ScalarRenderer.Render(scene);
        for (var i = 0; i < 16; i++) picture[50 + i % 4, 30 + i / 4] = (255, 0, 255);
        Assert.Equal(Finding.NoneOfThese, Diagnosis.Of(scene, picture).Finding);
    }

    [Theory(Explicit = true)]
    [InlineData("u-cross")]
    [InlineData("nohalf")]
    [InlineData("transpose")]
    [InlineData("crlf")]
    [InlineData("bgr")]
    [InlineData("no-t0")]
    [InlineData("circ-nosq")]
    [InlineData("tri-cull")]
    [InlineData("noclamp")]
    [InlineData("att-no2")]
    [InlineData("center")]
    public void NamesOtherPlantedMistakesFirst(string id) => new DiagnosisTests().NamesThePlantedMistakeFirst(id);

    [Fact(Explicit = true)]
    public void ARightPictureOfAnotherProgramMayHaveSingleOutlinePixelsOff()
    {
        var picture = ScalarRenderer.Render(scene);
        var y = picture.Height / 2;
        var x = Enumerable.Range(1, picture.Width - 1).First(x => PictureDifference.Levels(picture[x, y], picture[x - 1, y]) > 20);
        picture[x, y] = picture[x - 1, y];
        Assert.Equal(Finding.Matches, Diagnosis.Of(scene, picture).Finding);
    }

    [Fact(Explicit = true)]
    public void AMissingModelIsNamed()
    {
        for (var i = 0; i < scene.Models.Count; i += 4) AModelThatIsMissingIsNamed(scene, i);
    }

    [Theory(Explicit = true)]
    [InlineData("tri-uv")]
    [InlineData("cross-x")]
    [InlineData("rows")]
    public void NamesAMistakeInAMeshsPicture(string id)
    {
        var mesh = SceneFolder.Small("mesh", 4);
        Assert.Contains(id, Named(Diagnosis.Of(mesh, MistakeCatalog.Draw(mesh, [MistakeCatalog.Named(id)!])).Suspects[0]));
    }

    [Fact(Explicit = true)]
    public void AMistakeIsFoundBesideOneThatChangesMostOfThePicture()
    {
        var portrait = SceneFolder.Small("mistakes/portrait", 4);
        var picture = MistakeCatalog.Draw(portrait, [MistakeCatalog.Named("plane-no-p")!, MistakeCatalog.Named("clip-after")!]);
        Assert.Equal(["clip-after", "plane-no-p"], Diagnosis.Of(portrait, picture).Suspects[0].Mistakes.Select(mistake => mistake.Id).Order());
    }

    [Theory(Explicit = true)]
    [InlineData("cross-y", "tri-uv")]
    [InlineData("slab-2axes", "slab-minmin")]
    public void TwoMistakesOfOneShapeAreBothNamed(string one, string other)
    {
        var suspect = Diagnosis.Of(scene, MistakeCatalog.Draw(scene, [MistakeCatalog.Named(one)!, MistakeCatalog.Named(other)!])).Suspects[0];
        Assert.Equal([one, other], suspect.Mistakes.Select(mistake => mistake.Id).Order());
    }

    [Fact(Explicit = true)]
    public void NamesBothOfTwo()
    {
        var picture = Planted("rows");
        for (var i = 0; i < picture.Rgb.Length; i += 3) (picture.Rgb[i], picture.Rgb[i + 2]) = (picture.Rgb[i + 2], picture.Rgb[i]);
        var suspect = Diagnosis.Of(scene, picture).Suspects[0];
        Assert.Equal(["bgr", "rows"], suspect.Mistakes.Select(mistake => mistake.Id).Order());
    }

    [Theory(Explicit = true)]
    [InlineData("bgr")]
    public void ALengthWithoutItsRootIsNamedBesideOthers(string other) =>
        new DiagnosisTests().ALengthWithoutItsRootIsNamedBesideAnotherMistake(other);

    [Fact(Explicit = true)]
    public void EqualPicturesOfTwoMistakesAreNamedOnceAndMarked()
    {
        var picture = MistakeCatalog.Draw(scene, [MistakeCatalog.Named("dir-unnorm")!, MistakeCatalog.Named("att-no2")!]);
        var suspects = Diagnosis.Of(scene, picture).Suspects;
        var sets = suspects.Select(suspect => string.Join(' ', suspect.Mistakes.Select(mistake => mistake.Id).Order())).ToArray();
        Assert.Equal(sets.Distinct(), sets);
        Assert.Contains(suspects, suspect => suspect.SamePicture && suspect.Mistakes.Any(mistake => mistake.Id == "att-depth"));
        Assert.Contains(suspects, suspect => suspect.SamePicture && suspect.Mistakes.Any(mistake => mistake.Id == "dir-unnorm"));
    }

    [Fact(Explicit = true)]
    public void WhereNoneExplainsThePictureTheNearestIsToldAsSuch()
    {
        var skew = Written.As("camera V = W × U + 0.2·U");
        var diagnosis = Diagnosis.Of(scene, MistakeCatalog.Draw(scene, [skew, MistakeCatalog.Named("bgr")!]));
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.Contains(diagnosis.Nearest, nearest => Named(nearest).Contains("bgr"));
        Assert.Contains("none explains the picture", DiagnosisReport.Text(diagnosis, "mine.png", "scene.json"));
    }

    [Fact(Explicit = true)]
    public void AForeignPictureHasNoneOfThem()
    {
        var camera = scene.Camera;
        var foreign = new Picture(camera.Width, camera.Height);
        new Random(1).NextBytes(foreign.Rgb);
        var diagnosis = Diagnosis.Of(scene, foreign);
        Assert.Equal((Finding.NoneOfThese, 0), (diagnosis.Finding, diagnosis.Suspects.Count));
        Assert.StartsWith("This is another picture", Assert.Single(diagnosis.Likely));
    }

    [Fact(Explicit = true)]
    public void ASmallMistakeIsNamedBesideOneThatChangesEverything()
    {
        var picture = MistakeCatalog.Draw(scene, [MistakeCatalog.Named("gamma")!, MistakeCatalog.Named("tri-uv")!]);
        Assert.Equal(["gamma", "tri-uv"], Diagnosis.Of(scene, picture).Suspects[0].Mistakes.Select(mistake => mistake.Id).Order());
    }

    [Fact(Explicit = true)]
    public void NamesAMistakeThatShowsOnOutlinesOnly()
    {
        var axis = SceneFolder.Read(SceneFolder.FileOf("mistakes/axis"));
        var diagnosis = Diagnosis.Of(axis, EditedLab.Render(axis, Mistakes.Mistake.Named("slab-inv-nan")));
        Assert.Equal("slab-inv-nan", Assert.Single(diagnosis.Suspects[0].Mistakes).Id);
    }
}
