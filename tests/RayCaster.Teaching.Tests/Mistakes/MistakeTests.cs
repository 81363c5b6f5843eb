using System.Security.Cryptography;

namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>
/// The scenes in scenes/mistakes hide no mistake: whoever draws all of them right has made none of <see cref="Mistake.All"/>.
/// </summary>
public class MistakeTests
{
    private static readonly Dictionary<string, Scene> scenes =
        SceneFolder.Files("scenes/mistakes").ToDictionary(SceneFolder.NameOf, SceneFolder.Read);
    private static readonly Dictionary<string, Picture> right =
        scenes.ToDictionary(pair => pair.Key, pair => SlideCaster.Render(pair.Value, Mistake.None));

    /// <summary>Differences that the eye sees: by more than 2 levels, in as many pixels as a short thin line has.</summary>
    internal const int VisibleLevels = 2, VisiblePixels = 50;

    /// <summary>256 for 255 and truncating for rounding move a channel by one level at most: no scene can show them to the eye.</summary>
    private static readonly Mistake[] withinRounding = [Mistake.X256, Mistake.Round];

    public static TheoryData<string> Visible => [.. Mistake.All.Except(withinRounding).Select(mistake => mistake.Id)];

    public static TheoryData<string> WithinRounding => [.. withinRounding.Select(mistake => mistake.Id)];

    [Theory]
    [MemberData(nameof(Visible))]
    public void IsVisibleInAScene(string mistake) =>
        Assert.True(Changed(mistake, VisibleLevels).Values.Max() >= VisiblePixels, Table(mistake, VisibleLevels));

    [Theory]
    [MemberData(nameof(WithinRounding))]
    public void ChangesNothingByMoreThanALevelButManyPixelsByOne(string mistake)
    {
        Assert.True(Changed(mistake, 0).Values.Max() >= VisiblePixels, Table(mistake, 0));
        Assert.All(Changed(mistake, 1).Values, pixels => Assert.Equal(0, pixels));
    }

    [Fact]
    public void ThereAre71MistakesOfDifferentNames() => Assert.Equal(71, Mistake.All.Select(mistake => mistake.Id).Distinct().Count());

    [Fact]
    public void NoTwoMistakesGiveTheSamePictures()
    {
        var alike = Mistake.All.GroupBy(AllPictures).Where(group => group.Count() > 1);
        Assert.Empty(alike.Select(group => string.Join(" = ", group.Select(mistake => mistake.Id))));
    }

    private static string AllPictures(Mistake mistake) => string.Join(
        ' ', scenes.Values.Select(scene => Convert.ToHexString(SHA256.HashData(SlideCaster.Render(scene, mistake).Rgb))));

    /// <summary>In how many pixels of each scene the mistake changes a channel by more than so many levels.</summary>
    private static Dictionary<string, int> Changed(string mistake, int levels) => scenes.ToDictionary(
        pair => pair.Key,
        pair => ChangedPixels.Count(right[pair.Key], SlideCaster.Render(pair.Value, Mistake.Named(mistake)), levels));

    private static string Table(string mistake, int levels) =>
        $"no scene shows {mistake} ({Mistake.Named(mistake).What}); pixels that change by more than {levels} levels: " +
        string.Join(", ", Changed(mistake, levels).Select(pair => $"{pair.Key} {pair.Value}"));
}
