namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Shapes that somebody adds are drawn like the built-in ones.</summary>
public class AddedShapesTests
{
    [Fact]
    public void AFormulaIsDrawnLikeTheDefinition()
    {
        var ring = new Ring(Vector3.Zero, new(1, 0, 0), 1, 2);
        var scene = new Scene(new Camera(new(8, 3, 4), Vector3.Zero, width: 79, height: 53), [Model.Of(ring)], new Color(0, 0, 1));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }

    [Fact]
    public void PlainDoublesAndIfsAreDrawnLikeTheDefinition()
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
