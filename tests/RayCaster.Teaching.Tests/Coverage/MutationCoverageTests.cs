namespace RayCaster.Teaching.Tests.Coverage;

public class MutationCoverageTests
{
    [Fact]
    public void TheRoomSaysWhatItHides()
    {
        var room = SceneFolder.Read(SceneFolder.FileOf("room"));
        var coverage = MutationCoverage.Measure([room.WithSize(50, 50)]);
        var hidden = coverage.Hidden.Select(mistake => mistake.Id).ToArray();
        string[] expected = [
            "aspect-none", "aspect-int", "fov-horiz", "u-unnorm", "znear-t", "no-zfar", "near-root-only", "aspect-inv", "tca-positive"];
        Assert.Empty(expected.Except(hidden));
        Assert.Contains(coverage.SurvivorsInUsualForm, mistake => mistake.Id == "plane-cull"); // its planes face us, its disc does not
        Assert.Contains("the picture is square", CoverageReport.Text(coverage));
        Assert.Contains(coverage.Twins, group => group.Any(mistake => mistake.Id == "att-depth")
            && group.Any(mistake => mistake.Id == "dir-unnorm"));
    }

    /// <summary>A word that no reason has would say "nothing in the picture depends on it".</summary>
    [Fact]
    public void WhatHidesMistakesIsSaidInWords() => Assert.Equal(
        CoverageReport.Reasons.Order(), MistakeCatalog.All.SelectMany(mistake => mistake.HiddenBy).Distinct().Order());

    [Fact]
    public void AnEmptyWorldShowsNothing()
    {
        var coverage = MutationCoverage.Measure([new(new Camera(new(1, 0, 0), Vector3.Zero) { Width = 30, Height = 20 }, [])]);
        Assert.Contains(MistakeCatalog.Named("w-sign")!, coverage.Hidden);
        Assert.Contains("the world is empty", CoverageReport.Text(coverage));
    }

    [Fact(Explicit = true)]
    public void TheProjectsSetOfTestScenesHidesNothing()
    {
        var coverage = MutationCoverage.Measure(
            [.. SceneFolder.Files("scenes/mistakes").Select(file => SceneFolder.Small(SceneFolder.NameOf(file)))]);
        Assert.Equal(["round", "x256"], coverage.Hidden.Select(mistake => mistake.Id).Order()); // a level at most, by their nature
        Assert.Equal(coverage.Hidden, coverage.WithinRounding);
        Assert.Empty(coverage.Twins);
    }
}
