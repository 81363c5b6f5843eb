namespace RayCaster.Teaching.Tests.Comparison;

/// <summary>With the scene, a comparison speaks of models.</summary>
public class SceneDifferenceTests
{
    /// <summary>A wall behind a box and a ball, which has no name; a background.</summary>
    private static readonly Scene scene = new(
        new Camera(new(10, 0, 2), new(0, 0, 0)) { Width = 120, Height = 80, FovY = 60 },
        [
            Named(new Plane(new(-4, 0, 0), new(1, 0, -0.5)), "wall", new(0.8, 0.7, 0.6)),
            Named(new Aabb(new(-1, -3, -1), new(1, -1, 1.5)), "box", new(0.9, 0.2, 0.1)),
            Named(new Sphere(new(1, 2, 0), 1.2), null, new(0.1, 0.4, 0.9)),
        ],
        new(0.1, 0.2, 0.3));

    private static readonly Picture right = Renderer.Render(scene);

    private static string TextOf(Picture mine, Picture? reference = null, Scene? of = null) =>
        ComparisonText.Format(new PictureComparison(mine, reference ?? right, of ?? scene), "mine", "reference");

    private static Model Named<P>(P primitive, string? name, Color color) where P : struct, IPrimitive =>
        new Model<P>(primitive) { Name = name, Color = color };

    private static Scene Without(int model) => scene with { Models = [.. scene.Models.Where((_, i) => i != model)] };

    private static Scene With(int index, Model model) => scene with { Models = [.. scene.Models.Select((old, i) => i == index ? model : old)] };

    [Fact]
    public void AMissingModelIsNamedWithWhatItsPixelsShow() =>
        Assert.Contains("\n`box` is missing: 100 % of its pixels show `wall`; all others agree.", TextOf(Renderer.Render(Without(1))));

    [Fact]
    public void AModelBeforeTheBackgroundUncoversIt()
    {
        var open = Without(0);
        Assert.Contains("\n`box` is missing: 100 % of its pixels show the background; all others agree.",
            TextOf(Renderer.Render(open with { Models = [open.Models[1]] }), Renderer.Render(open), open));
    }

    [Fact]
    public void AModelWithoutANameIsNamedByItsPlaceAndType() =>
        Assert.Contains(
            "\nmodels[2] (sphere) is missing: 100 % of its pixels show `wall`; all others agree.", TextOf(Renderer.Render(Without(2))));

    [Fact]
    public void ModelsOfTheSameNameAreToldApartByTheirPlace()
    {
        var twins = With(2, Named(new Sphere(new(1, 2, 0), 1.2), "box", new(0.1, 0.4, 0.9)));
        Assert.Contains("\n`box` (models[2]) is missing", TextOf(Renderer.Render(Without(2)), Renderer.Render(twins), twins));
    }

    [Theory]
    [InlineData(0.2, 0.5, 0.4, "`box` has another colour: (0.2, 0.5, 0.4) instead of (0.9, 0.2, 0.1)")]
    [InlineData(0.45, 0.1, 0.05, "`box` is darker: 0.5 times what it should be")]
    [InlineData(0, 0, 0, "`box` is black")]
    public void AnotherColourIsTold(double red, double green, double blue, string told)
    {
        var other = With(1, Named(new Aabb(new(-1, -3, -1), new(1, -1, 1.5)), "box", new(red, green, blue)));
        Assert.Contains($"\n{told}; all others agree.\n", TextOf(Renderer.Render(other)));
    }

    [Fact]
    public void WhatWrongPixelsShowIsTold()
    {
        var mine = Renderer.Render(scene);
        var wall = Renderer.Render(scene with { Models = [scene.Models[0]] });
        for (var y = 0; y < 40; y++) // the upper half of the picture has no ball
            for (var x = 60; x < 120; x++) mine[x, y] = wall[x, y];
        var comparison = new PictureComparison(mine, right, scene);
        var ball = comparison.ByModels!.Models[0];
        Assert.Equal([(0, ball.Wrong)], ball.Shows);
        Assert.InRange(ball.Share, 0.3, 0.7);
        Assert.Matches(@"\nmodels\[2\] \(sphere\): [\d.]+ % of its pixels are wrong, they show `wall`; all others agree\.\n",
            ComparisonText.Format(comparison, "mine", "reference"));
    }

    [Fact]
    public void AModelThatIsMissingAndOneOfAnotherColourAreBothTold()
    {
        var green = Named(new Aabb(new(-1, -3, -1), new(1, -1, 1.5)), "box", new(0.2, 0.5, 0.4));
        var text = TextOf(Renderer.Render(scene with { Models = [scene.Models[0], green] }));
        Assert.Contains("\n`box` has another colour", text);
        Assert.Contains("\nmodels[2] (sphere) is missing", text);
        Assert.DoesNotContain("all others agree", text);
    }

    [Fact]
    public void TheTableBeginsWithTheMostWrong()
    {
        var models = new PictureComparison(Renderer.Render(Without(1)), right, scene).ByModels!.Models;
        Assert.Equal(("`box`", 1.0), (models[0].Name, models[0].Share));
        Assert.Equal(right.Width * right.Height, models.Sum(model => model.Pixels));
    }

    [Fact]
    public void OfAnotherScenesReferenceNothingIsSaidOfModels()
    {
        var other = Renderer.Render(scene with { Models = [] });
        var text = TextOf(other.With(picture => picture[0, 0] = (9, 9, 9)), other);
        Assert.Contains("The reference is not the picture of this scene", text);
        Assert.DoesNotContain("`", text);
    }

    [Fact]
    public void SwappedPicturesAreNoticed() =>
        Assert.Contains("The scene's own picture is mine, not the reference: are the two swapped?", TextOf(right, Renderer.Render(Without(1))));

    [Fact]
    public void AWholePicturesChangeIsNotBlamedOnModels() =>
        Assert.DoesNotContain("`", TextOf(Picture.Create(120, 80, (x, y) => right[x, 79 - y])));

    [Fact]
    public void WhereEverythingIsWrongNoModelIsBlamed()
    {
        var camera = new Camera(new(10, 3, 4), new(0, 0, 0)) { Width = 120, Height = 80, FovY = 90 };
        Assert.Contains("The outlines are others: look at the camera", TextOf(Renderer.Render(scene with { Camera = camera })));
    }

    [Fact]
    public void TheScenesSizeDoesNotMatter() => Assert.Contains(
        "`box` is missing", TextOf(Renderer.Render(Without(1)), null, scene.WithSize(500, 500)));

    [Fact]
    public void APixelThatHangsOnAThousandthOfAPixelMayShowEither()
    {
        // The edge of the quarter plane runs exactly along a column of corners.
        var camera = new Camera(new(10, 0, 0), new(0, 0, 0)) { Width = 60, Height = 40 };
        var edge = new Scene(camera, [Named(new Aabb(new(-1, 0, -90), new(1, 90, 90)), "half", new(1, 1, 1))], new(0, 0, 0.5));
        var reference = Renderer.Render(edge);
        Assert.NotEqual(reference[29, 0], reference[30, 0]);
        var shifted = Picture.Create(60, 40, (x, y) => x == 30 ? reference[29, y] : reference[x, y]);
        Assert.Equal(Likeness.OutlinesOnly, new PictureComparison(shifted, reference, edge).Likeness);
        var farther = Picture.Create(60, 40, (x, y) => x == 31 ? reference[29, y] : reference[x, y]);
        Assert.Equal(Likeness.Wrong, new PictureComparison(farther, reference, edge).Likeness);
    }

    [Theory]
    [InlineData(0, Likeness.Identical)]
    [InlineData(1, Likeness.OutlinesOnly)]
    [InlineData(2, Likeness.OutlinesOnly)]
    [InlineData(3, Likeness.Wrong)]
    public void OfModelsAtTheSameDistanceEachMayShow(int shown, Likeness likeness)
    {
        var tie = scene with
        {
            Models = [.. ((double[])[0, 0, 0, -1]).Select((x, i) => Named(new Plane(new(x, 0, 0), new(1, 0, 0)), $"wall {i}", new(1, 0.2 * i, 0)))],
        };
        var mine = Renderer.Render(tie with { Models = [tie.Models[shown]] });
        Assert.Equal(likeness, new PictureComparison(mine, Renderer.Render(tie), tie).Likeness);
    }
}
