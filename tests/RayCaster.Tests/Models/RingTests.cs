namespace RayCaster.Tests.Models;

/// <summary>A shape that somebody adds as a formula is drawn in packets like the built-in ones.</summary>
public class RingTests
{
    private readonly Ring ring = new(Vector3.Zero, new(1, 0, 0), 1, 2);

    [Theory]
    [InlineData(0.5, false)]
    [InlineData(1, true)]
    [InlineData(1.5, true)]
    [InlineData(2, true)]
    [InlineData(2.5, false)]
    public void ItIsHitBetweenItsRadii(double y, bool hit) =>
        Assert.Equal(hit ? 10 : (double?)null, Model.Of(ring).Intersect(new Ray(new(10, y, 0), new(-1, 0, 0))));

    [Fact]
    public void TheFastRendererDrawsItLikeTheDefinition()
    {
        var scene = new Scene(new Camera(new(8, 3, 4), Vector3.Zero, width: 79, height: 53), [Model.Of(ring)], new Color(0, 0, 1));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }
}
