namespace RayCaster.Teaching.Tests.Coverage;

public class MutationCoverageTests
{
    [Fact]
    public void TheRoomSaysWhatItHides()
    {
        var room = SceneFolder.Read(SceneFolder.FileOf("room"));
        var fitness = MutationCoverage.Measure([room.WithSize(50, 50)]);
        var hidden = fitness.Hidden.Select(mistake => mistake.Id).ToArray();
        string[] expected = [
            "aspect-none", "aspect-int", "fov-horiz", "u-unnorm", "znear-t", "no-zfar", "near-root-only", "aspect-inv", "tca-positive"];
        Assert.Empty(expected.Except(hidden));
        Assert.Contains(fitness.SurvivorsInUsualForm, mistake => mistake.Id == "plane-cull"); // its planes face us, its disc does not
        Assert.Contains("the picture is square", CoverageReport.Text(fitness));
        Assert.Contains(fitness.Twins, group => group.Any(mistake => mistake.Id == "att-depth") && group.Any(mistake => mistake.Id == "dir-unnorm"));
    }

    /// <summary>A word that no reason has would say "nothing in the picture depends on it".</summary>
    [Fact]
    public void WhatHidesMistakesIsSaidInWords() => Assert.Equal(
        CoverageReport.Reasons.Order(), MistakeCatalog.All.SelectMany(mistake => mistake.HiddenBy).Distinct().Order());

    [Fact]
    public void AnEmptyWorldShowsNothing()
    {
        var fitness = MutationCoverage.Measure([new(new Camera(new(1, 0, 0), Vector3.Zero) { Width = 30, Height = 20 }, [])]);
        Assert.Contains(MistakeCatalog.Named("w-sign")!, fitness.Hidden);
        Assert.Contains("the world is empty", CoverageReport.Text(fitness));
    }

    [Fact(Explicit = true)]
    public void TheProjectsSetOfTestScenesHidesNothing()
    {
        var fitness = MutationCoverage.Measure(
            [.. SceneFolder.Files("scenes/mistakes").Select(file => SceneFolder.Small(SceneFolder.NameOf(file)))]);
        Assert.Equal(["round", "x256"], fitness.Hidden.Select(mistake => mistake.Id).Order()); // a level at most, by their nature
        Assert.Equal(fitness.Hidden, fitness.WithinRounding);
        Assert.Empty(fitness.Twins);
    }
}
