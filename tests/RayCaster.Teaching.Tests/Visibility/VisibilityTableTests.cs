namespace RayCaster.Teaching.Tests.Visibility;

/// <summary>What is odd is said in words, with what to change.</summary>
public class VisibilityTableTests
{
    private static readonly Model Ball = Model.Of(new Sphere(Vector3.Zero, 2));

    [Fact]
    public void TheTableHasALineForEachModelAndAColumnForWhatOccurs()
    {
        var camera = new Camera(new(10, 0, 0), Vector3.Zero) { Width = 4, Height = 2 };
        Model wall = Model.Of(new Plane(new(-5, 0, 0), new(1, 0, 0))), after = Model.Of(new Plane(new(-6, 0, 0), new(1, 0, 0)));
        wall.Name = "wall";
        Assert.Equal("""
            What became of 8 rays, model by model:
              model                  shows     hidden
              wall                       8          -
              models[1] (plane)          -          8
            models[1] (plane) does not show: it is hit by 8 rays, but something nearer hides it there.

            """.ReplaceLineEndings("\n"), SceneVisibility.Take(new Scene(camera, [wall, after])).Report());
    }

    [Fact]
    public void OneRayIsNotSeveral() => Assert.StartsWith("What became of 1 ray, model by model:\n",
        Report(new Camera(new(10, 0, 0), Vector3.Zero) { Width = 1, Height = 1 }));

    [Fact]
    public void NothingOddIsSaidToo() =>
        Assert.EndsWith("Nothing odd: every model shows.\n", Report(View(10, 0)));

    [Fact]
    public void AMeshOfWhichNothingIsLeftIsNotLookedPast() =>
        Assert.EndsWith("\nNothing of the mesh is left: none of its triangles has an area.\n",
            SceneVisibility.Take(new Scene(View(10, 0), [new Mesh([], [])])).Report());

    public static TheoryData<Camera, string> Odd => new()
    {
        { View(-10, -20), "0 of 600 rays hit anything: models[0] (sphere) lies behind the camera." },
        { View(-10, -200), "The camera looks away from them: towards target = [180, 0, 0] 19 % of the rays hit something." },
        { View(3, 12), "Are position and target swapped? From [12, 0, 0] towards [3, 0, 0] 13 % of the rays hit something." },
        { View(10, 0) with { ZNear = 50 }, "0 of 600 rays hit anything: models[0] (sphere) lies nearer than zNear.\n" +
            "zNear is 50, but their crossings lie at z = 12 and less. Make zNear smaller, or move the camera back." },
        { View(10, 0) with { ZFar = 5 }, "zFar is 5, but their crossings lie at z = 8 and more. Make zFar greater." },
        { View(10, 0) with { Bias = 40 },
            "models[0] (sphere) is crossed only at t <= bias.\nbias is 40: only t > bias is a hit. Make it smaller; 1e-6 is usual." },
        { View(10, 8), "hits are black: attenuation = 1 - t / (2 |T - P|) is 0 from t = 4 on, and their t is 8" },
        { View(10, 9) with { Target = new(9, 1, 0) }, "They lie beside the picture: aim target at them (it is [9, 1, 0])" },
        { View(10, -10) with { Position = new(10, 50, 0), Target = new(-10, 50, 0), FovY = 120 }, "The camera looks past them" },
    };

    [Theory]
    [MemberData(nameof(Odd))]
    public void WhatIsOddIsTold(Camera camera, string sentence) => Assert.Contains(sentence, Report(camera));

    [Fact]
    public void ASceneWithoutModelsIsTold() => Assert.EndsWith(
        "The scene holds no models: every pixel shows the background.\n",
        SceneVisibility.Take(new Scene(View(10, 0), [])).Report());

    [Fact]
    public void ABackgroundOfTheModelsColourIsTold()
    {
        var glaring = Model.Of(new Sphere(Vector3.Zero, 2));
        glaring.Color = new(100, 100, 100);
        var scene = new Scene(View(10, 0), [glaring], Color.White);
        Assert.Contains("The background has the same colour", SceneVisibility.Take(scene).Report());
    }

    /// <summary>A camera on the x axis that looks along it.</summary>
    private static Camera View(double position, double target) => new(new(position, 0, 0), new(target, 0, 0)) { Width = 30, Height = 20 };

    private static string Report(Camera camera) => SceneVisibility.Take(new Scene(camera, [Ball])).Report();
}
