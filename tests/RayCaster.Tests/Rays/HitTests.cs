namespace RayCaster.Tests.Rays;

/// <summary>Which model a pixel shows, and how bright.</summary>
public class HitTests
{
    /// <summary>One pixel whose ray runs from (10, 0, 0) along −x; the target is the origin, so the light ends at t = 20.</summary>
    private static readonly Camera camera =
        new(new(10, 0, 0), default) { Width = 1, Height = 1, ZNear = 0, Sample = PixelSample.Center };

    private static Model Wall(double x, Color color) => new Model<Plane>(new Plane(new(x, 0, 0), new(1, 0, 0))) { Color = color };

    private static (int, int, int) Shade(params Model[] models) =>
        ScalarRenderer.Render(new Scene(camera, models, new Color(0.2, 0.4, 0.6)))[0, 0];

    [Theory]
    [InlineData(5, 191)]   // t = 5: 1 − 5 / 20 = 0.75
    [InlineData(0, 128)]   // t = 10, at the target: one half
    [InlineData(-9, 13)]   // t = 19: 0.05
    [InlineData(-10, 0)]   // t = 20
    [InlineData(-50, 0)]   // t = 60: black, not negative
    public void TheColourFadesWithTheDistance(double x, byte expected) => Assert.Equal((expected, 0, 0), Shade(Wall(x, new(1, 0, 0))));

    [Fact]
    public void ASurfaceThatTheCameraIsInIsWithinTheBiasAndNotSeen() =>
        Assert.Equal((0, 128, 0), Shade(Wall(10, new(1, 0, 0)), Wall(0, new(0, 1, 0))));

    [Fact]
    public void TheBackgroundDoesNotFade() => Assert.Equal((51, 102, 153), Shade());

    [Fact]
    public void TheNearestModelShowsWhateverTheOrder()
    {
        var (near, far) = (Wall(2, new(1, 0, 0)), Wall(1, new(0, 1, 0)));
        Assert.Equal(Shade(near, far), Shade(far, near));
        Assert.Equal((153, 0, 0), Shade(far, near)); // t = 8: 0.6
    }

    [Fact]
    public void OfTwoAtTheSamePlaceTheFirstInTheSceneShows()
    {
        var (red, green) = (Wall(0, new(1, 0, 0)), Wall(0, new(0, 1, 0)));
        Assert.Equal((128, 0, 0), Shade(red, green));
        Assert.Equal((0, 128, 0), Shade(green, red));
    }

    [Fact]
    public void WhatIsClippedAwayHidesNothing()
    {
        var clipped = new Camera(camera.Position, camera.Target) { Width = 1, Height = 1, ZNear = 6, ZFar = 10, Sample = PixelSample.Center };
        var scene = new Scene(clipped, [Wall(5, new(1, 0, 0)), Wall(0, new(0, 1, 0)), Wall(-1, new(0, 0, 1))]);
        Assert.Equal((0, 128, 0), ScalarRenderer.Render(scene)[0, 0]);
    }

    [Fact]
    public void AColourBeyondFullIntensityFadesBeforeItIsClamped() => Assert.Equal((255, 191, 0), Shade(Wall(-5, new(8, 3, 0))));

    [Fact]
    public void RowsAreCountedFromTheBottomAndColumnsFromTheLeft()
    {
        var four = new Camera(default, new(-1, 0, 0)) { FovY = 90, Width = 2, Height = 2, ZNear = 0, Sample = PixelSample.Center };
        Model ball = new Model<Sphere>(new Sphere(new(-1, 0.5, 0.5), 0.1)); // to the right and above
        var picture = ScalarRenderer.Render(new Scene(four, [ball], Color.Black));
        Assert.NotEqual((0, 0, 0), picture[1, 0]);
        foreach (var (x, y) in new[] { (0, 0), (0, 1), (1, 1) }) Assert.Equal((0, 0, 0), picture[x, y]);
    }
}
