using RayCaster.Teaching.Tests.Mistakes;
using Planted = RayCaster.Teaching.Tests.Mistakes.Mistake;

namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>The catalogue, against the lab, whose source is edited to have the same mistakes.</summary>
public class CatalogTests
{
    internal static readonly Dictionary<string, Scene> scenes =
        SceneFolder.Files("scenes/mistakes").Select(SceneFolder.NameOf).ToDictionary(name => name, name => SceneFolder.Small(name, 4));

    /// <summary>The share of pixels beyond a level that other last bits of the same mistake may change.</summary>
    private const double Share = 0.0002;

    public static TheoryData<string> Ids => [.. Planted.All.Select(mistake => mistake.Id)];

    internal static bool IsDrawnBy(Picture expected, Picture actual) =>
        (expected.Width, expected.Height) == (actual.Width, actual.Height)
        && ChangedPixels.Count(expected, actual, levels: 1) <= Share * expected.Width * expected.Height;

    [Fact]
    public void KnowsEveryPlantedMistakeByItsId()
    {
        var ids = MistakeCatalog.All.Select(mistake => mistake.Id).ToArray();
        Assert.Equal(ids.Length, ids.Distinct().Count());
        Assert.Empty(Planted.All.Select(mistake => mistake.Id).Except(ids));
        Assert.Equal(71, Planted.All.Select(mistake => mistake.Id).Distinct().Count());
        Assert.All(ids, id => Assert.Equal(id, MistakeCatalog.Named(id)!.Id));
        Assert.Null(MistakeCatalog.Named("no-such-mistake"));
    }

    [Fact]
    public void EverySlideIsOneOfTheDocs()
    {
        var titles = File.ReadAllLines(ProjectFolder.PathOf("docs/slides-to-code.md"))
            .Where(line => line.StartsWith("| ", StringComparison.Ordinal)).Select(line => line.Split('|')[1].Trim()).ToHashSet();
        Assert.All(MistakeCatalog.All, mistake => Assert.Contains(mistake.Slide, titles));
    }

    [Fact]
    public void WhatASceneDoesNotHaveIsNotTouched()
    {
        var scene = SceneFolder.Small("sphere", 4);
        var right = MistakeCatalog.Draw(scene, []).Rgb;
        var untouched = MistakeCatalog.All.Where(mistake => !mistake.Touches(scene));
        Assert.All(untouched, mistake => Assert.Equal(right, MistakeCatalog.Draw(scene, [mistake]).Rgb));
        Assert.True(MistakeCatalog.Named("r-nosq")!.Touches(scene));
        Assert.False(MistakeCatalog.Named("tri-uv")!.Touches(scene));
    }
}
