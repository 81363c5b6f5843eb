namespace RayCaster.Tests.Models;

/// <summary>A model in plain doubles and ifs takes part like any other.</summary>
public class CylinderTests
{
    [Fact]
    public void ItIsHitFromOutsideAndFromInside()
    {
        var tube = new Cylinder(Vector3.Zero, 2, 4);
        Assert.Equal(8, tube.Intersect(new Ray(new(10, 0, 1), new(-1, 0, 0))));
        Assert.Equal(2, tube.Intersect(new Ray(new(0, 0, 1), new(-1, 0, 0))));
        Assert.Null(tube.Intersect(new Ray(new(10, 0, 3), new(-1, 0, 0))));
        Assert.Null(tube.Intersect(new Ray(new(0, 0, 10), new(0, 0, -1))));
    }

    [Fact]
    public void TheFastRendererDrawsItLikeTheDefinition()
    {
        var camera = new Camera(new(8, 3, 4), Vector3.Zero, width: 79, height: 53);
        var scene = new Scene(camera,
        [
            new Cylinder(new(0, 0, 0.5), 1.5, 3) { Color = new(1, 0.5, 0) },
            Model.Of(new Plane(new(0, 0, -1), new(0, 0, 1))),
            new Cylinder(new(1, -2, 0), 1, 2) { Color = new(0, 0.5, 1) },
        ]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }
}
