namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>The library and a ray caster written apart from it, from the slides, draw the same pictures.</summary>
public class SlideCasterTests
{
    public static TheoryData<string> Scenes =>
    [
        .. SceneFolder.Files("scenes").Concat(SceneFolder.Files("scenes/mistakes"))
            .Select(SceneFolder.NameOf).Except(["mesh", "mesh-formats"]),
    ];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void WithoutAMistakeItDrawsWhatTheLibraryDraws(string name)
    {
        var scene = SceneFolder.Small(name);
        var expected = SlideCaster.Render(scene, Mistake.None);
        var actual = ScalarRenderer.Render(scene);
        Assert.Equal((expected.Width, expected.Height), (actual.Width, actual.Height));
        // Other formulas for the same t: their last bits may turn a pixel on an outline, or round a channel the other way.
        // It happens once in millions of pixels: with .NET 10 on x64 in none of these pictures.
        Assert.True(ChangedPixels.Count(expected, actual, levels: 0) <= 3,
            ComparisonText.Of(new PictureComparison(actual, expected), $"scenes/{name}.json", "the slides' picture"));
    }
}
