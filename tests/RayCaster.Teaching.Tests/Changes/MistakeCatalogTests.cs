
namespace RayCaster.Teaching.Tests.Changes;

/// <summary>The catalogue, against the lab, whose source is edited to have the same mistakes.</summary>
public class MistakeCatalogTests
{
    private static readonly Dictionary<string, Scene> scenes =
        SceneFolder.Files("scenes/mistakes").Select(SceneFolder.NameOf).ToDictionary(name => name, name => SceneFolder.Small(name, 4));

    /// <summary>The share of pixels beyond a level that other last bits of the same mistake may change.</summary>
    private const double Share = 0.0002;

    public static TheoryData<string> Ids => [.. PlantedMistake.All.Select(mistake => mistake.Id)];

    private static bool IsDrawnBy(Picture expected, Picture actual) =>
        (expected.Width, expected.Height) == (actual.Width, actual.Height)
        && ChangedPixels.Count(expected, actual, levels: 1) <= Share * expected.Width * expected.Height;

    [Fact]
    public void KnowsEveryPlantedMistakeByItsId()
    {
        var ids = MistakeCatalog.All.Select(mistake => mistake.Id).ToArray();
        Assert.Equal(ids.Length, ids.Distinct().Count());
        Assert.Empty(PlantedMistake.All.Select(mistake => mistake.Id).Except(ids));
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
        var scene = SceneFolder.Small("sphere", 10);
        var right = MistakeCatalog.Draw(scene, []).Rgb;
        var untouched = MistakeCatalog.All.Where(mistake => !mistake.Touches(scene));
        Assert.All(untouched, mistake => Assert.Equal(right, MistakeCatalog.Draw(scene, [mistake.Usual]).Rgb));
        Assert.True(MistakeCatalog.Named("r-nosq")!.Touches(scene));
        Assert.False(MistakeCatalog.Named("tri-uv")!.Touches(scene));
    }

    [Fact]
    public void AMisspelledShapeIsRefused() =>
        Assert.Throws<FormatException>(() => ChangeReader.Read("for spere rule hit = z ≤ zFar").ToArray());

    /// <summary>A variant draws it in all scenes; or it is written in another way, which the diagnosis names in a scene.</summary>
    [Theory(Explicit = true)]
    [MemberData(nameof(Ids))]
    public void WhatTheLabWithThatMistakeDrawsIsKnown(string id)
    {
        var drawn = scenes.Values.Select(scene => (Scene: scene, Picture: EditedLab.Render(scene, PlantedMistake.Named(id)))).ToArray();
        if (MistakeCatalog.Named(id)!.Changes.Any(variant =>
            drawn.All(one => IsDrawnBy(one.Picture, MistakeCatalog.Draw(one.Scene, [variant]))))) return;
        Assert.Contains(drawn,
            one => DiagnosisResult.Find(one.Scene, one.Picture, new()).Suspects is [var first, ..] && DiagnosisTests.Named(first).Contains(id));
    }

    [Fact(Explicit = true)]
    public void EveryVariantKeepsTheIdAndShowsSomewhere()
    {
        Assert.All(MistakeCatalog.All, mistake => Assert.Same(mistake.Usual, mistake.Changes[0]));
        Assert.All(MistakeCatalog.All, mistake => Assert.All(mistake.Changes, variant => Assert.Equal(mistake.Id, variant.Id)));
        var worded = MistakeCatalog.All.Where(mistake => mistake.Changes.Count > 1); // SceneFitnessTests show it for the others
        Change[] hidden = [.. worded.SelectMany(mistake => mistake.Changes)
            .Where(variant => rights.All(scene => ChangedPixels.Count(scene.Right, MistakeCatalog.Draw(scene.Scene, [variant]), levels: 0) == 0))];
        Assert.True(hidden.Length == 0, string.Join(Environment.NewLine, hidden.Select(variant => $"{variant}: {variant.Cause}")));
    }

    private static readonly (Scene Scene, Picture Right)[] rights =
        [.. scenes.Values.Append(SceneFolder.Small("room", 4)).Append(Everywhere).Select(scene => (scene, ScalarRenderer.Render(scene)))];

    /// <summary>A small scene with each kind of shape before zNear, beyond zFar and behind the camera, where depth and t are on different sides of
    /// zNear and of zFar, and with a red over 1.</summary>
    private static Scene Everywhere
    {
        get
        {
            Model[] models =
            [
                new Model<Plane>(new(new(0, 0, -1.2), new(0, 0, 1))) { Color = new(1.9, 1, 1) },
                .. ((Vector3[])[new(0, -8, 0.8), new(0, 6, 4), new(0, -14, 0), new(0, -6.3, 1.7), new(0, 1.6, 4)])
                    .SelectMany(place => Row(place, Math.Abs(place.Y + 10) / 8)),
            ];
            return new(new(new(0, -10, 0), Vector3.Zero) { FovY = 60, Width = 36, Height = 24, ZNear = 4, ZFar = 12 }, models);

            static Model[] Row(Vector3 at, double size)
            {
                var (right, half) = (size * new Vector3(1, 0, 0), size / 2 * new Vector3(1, 1, 1));
                return
                [
                    Model.Of(new Sphere(at - 3 * right, size / 2)),
                    Model.Of(new Aabb(at - right - half, at - right + half)),
                    Model.Of(new Circle(at + right, new(0, 1, 0.2), size / 2)),
                    Model.Of(new Triangle(at + 3 * right, at + 4 * right, at + 3 * right + size * new Vector3(0, 0.2, 1))),
                ];
            }
        }
    }
}
