namespace RayCaster.Teaching.Tests.Visibility;

/// <summary>The ledger counts what the pictures show, and says why the rest is refused.</summary>
public class SceneVisibilityTests
{
    /// <summary>Looks from (10, 0, 0) along −x.</summary>
    private static readonly Camera Camera = new(new(10, 0, 0), Vector3.Zero) { FovY = 60, Width = 24, Height = 16, ZNear = 2, ZFar = 50, Bias = 1 };

    [Fact]
    public void AModelShowsInAsManyPixelsAsTheRendererFinds()
    {
        for (var seed = 0; seed < 20; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            var (ledger, hits) = (SceneVisibility.Take(scene), new Renderer(scene).CastHits());
            Assert.Equal(hits.Model.Length, ledger.Rays);
            Assert.Equal(hits.Model.Count(model => model >= 0), ledger.Hits);
            for (var i = 0; i < scene.Models.Count; i++)
                Assert.Equal((seed, i, hits.Model.Count(model => model == i)), (seed, i, ledger.Models[i][Outcome.Shows]));
        }
    }

    [Fact]
    public void AModelIsHitWhereItWouldShowAlone()
    {
        for (var seed = 100; seed < 130; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            var ledger = SceneVisibility.Take(scene);
            for (var i = 0; i < scene.Models.Count; i++)
                Assert.Equal(
                    new Renderer(scene with { Models = [scene.Models[i]] }).CastHits().Model.Count(model => model >= 0), ledger.Models[i].Hits);
        }
    }

    [Fact]
    public void EachRayIsCountedOnceForEachModel()
    {
        for (var seed = 0; seed < 30; seed++)
        {
            var ledger = SceneVisibility.Take(RandomScene.Make(new Random(seed)));
            Assert.All(ledger.Models, entry => Assert.Equal(ledger.Rays, Enum.GetValues<Outcome>().Sum(outcome => entry[outcome])));
        }
    }

    [Theory]
    [InlineData(5, Outcome.Shows)]
    [InlineData(12, Outcome.Behind)]
    [InlineData(9.5, Outcome.UnderBias)]
    [InlineData(8.5, Outcome.BeforeNear)]
    [InlineData(-41, Outcome.BeyondFar)]
    public void AWallAcrossTheViewIsRefusedForOneReason(double x, Outcome outcome)
    {
        var mesh = new Mesh([new(x, -99, -99), new(x, 200, -99), new(x, -99, 200)], [0, 1, 2]);
        foreach (var wall in (Model[])[Model.Of(new Plane(new(x, 0, 0), new(1, 0, 0))), mesh])
        {
            var entry = Assert.Single(Take(wall).Models);
            Assert.Equal(384, entry[outcome] + (outcome == Outcome.UnderBias ? entry[Outcome.BeforeNear] : 0)); // where t > 1 at the corners
            Assert.InRange(entry[outcome], 300, 384);
        }
    }

    [Fact]
    public void WhatLiesBehindAnotherIsHidden()
    {
        var ledger = Take(Model.Of(new Plane(new(-3, 0, 0), new(1, 0, 0))), Model.Of(new Plane(new(0, 0, 0), new(1, 0, 0))));
        Assert.Equal((384, 384), (ledger.Models[0][Outcome.Hidden], ledger.Models[1][Outcome.Shows]));
    }

    [Fact]
    public void OfTwoAtTheSamePlaceTheSecondIsHidden()
    {
        var wall = new Plane(Vector3.Zero, new(1, 0, 0));
        var ledger = Take(Model.Of(wall), Model.Of(wall));
        Assert.Equal((384, 384), (ledger.Models[0][Outcome.Shows], ledger.Models[1][Outcome.Hidden]));
    }

    public static TheoryData<string, Model> Missed => new()
    {
        { "sphere", Model.Of(new Sphere(new(0, 100, 0), 1)) },
        { "circle", Model.Of(new Circle(new(0, 100, 0), new(1, 0, 0), 1)) },
        { "triangle", Model.Of(new Triangle(new(0, 100, 0), new(0, 101, 0), new(0, 100, 1))) },
        { "box", Model.Of(new Aabb(new(0, 100, 0), new(1, 101, 1))) },
        { "mesh", new Mesh([new(0, 100, 0), new(0, 101, 0), new(0, 100, 1)], [0, 1, 2]) },
        { "ring", Model.Of(new Ring(Vector3.Zero, new(1, 0, 0), 50, 60)) },
        { "tube", new Cylinder(new(0, 100, 0), 1, 1) },
    };

    [Theory]
    [MemberData(nameof(Missed))]
    public void AModelBesideEveryRayIsMissed(string shape, Model model) =>
        Assert.Equal((shape, 384), (shape, Assert.Single(Take(model).Models)[Outcome.Misses]));

    [Fact]
    public void ARayThatRunsAlongAPlaneMissesIt()
    {
        foreach (var z in new[] { 0.0, 5 }) // in the plane, and beside it
        {
            var scene = new Scene(
                Camera with { Width = 1, Height = 2 },
                [Model.Of(new Plane(new(0, 0, z), new(0, 0, 1))), Model.Of(new Circle(new(0, 0, z), new(0, 0, 1), 3))]);
            Assert.Equal([1, 2], SceneVisibility.Take(scene).Models.Select(entry => entry[Outcome.Misses])); // row 1 of 2 looks along −x
        }
    }

    [Fact]
    public void AScalarShapeSaysWhereItIsHitUnclipped()
    {
        Assert.Equal(Outcome.Behind, Assert.Single(Take(new Cylinder(new(20, 0, 0), 1, 99)).Models).Reason);
        Assert.Equal(Outcome.BeyondFar, Assert.Single(Take(new Cylinder(new(-90, 0, 0), 1, 99)).Models).Reason);
    }

    [Fact]
    public void OfALargePictureAGridIsJudged()
    {
        var scene = new Scene(Camera with { Width = 8000, Height = 4000 }, [Model.Of(new Plane(Vector3.Zero, new(1, 0, 0)))]);
        var ledger = SceneVisibility.Take(scene);
        Assert.InRange(ledger.Rays, SceneVisibility.MaxSampled / 2, SceneVisibility.MaxSampled);
        Assert.Contains($"judged from {ledger.Rays:N0} of 32,000,000:", ledger.Report());
    }

    private static SceneVisibility Take(params Model[] models) => SceneVisibility.Take(new Scene(Camera, models));
}
