namespace RayCaster.Engine.Tests.Rendering;

/// <summary>A shape that the engine has never heard of is drawn like the library's.</summary>
public class NewShapeTests
{
    private static readonly Model[] balls = [.. Enumerable.Range(0, 100).Select(i => Model.Of(new Ball(new(0, i % 10 - 5, i / 10 - 5), 0.4)))];

    [Fact]
    public void WithBoundsItJoinsTheBatch()
    {
        var lists = ShapeLists.Of(balls, isKept: false, threads: 1);
        Assert.Single(lists.Lists);
        Assert.Empty(lists.Others);
    }

    [Theory]
    [InlineData(3)]
    [InlineData(100)]
    public void ItsPictureIsTheDefinitions(int count)
    {
        var scene = new Scene(new(new(20, 1, 2), Vector3.Zero, width: 150, height: 150), balls[..count]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }

    private readonly record struct Ball(Vector3 Center, double Radius) : IPrimitive, IRound
    {
        public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => new Sphere(Center, Radius).Intersect(ray);
    }
}
