namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Shapes that somebody adds, of which the engine has never heard, are drawn like the built-in ones.</summary>
public class AddedShapesTests
{
    private static readonly Dictionary<string, Model[]> models = new()
    {
        ["a formula"] = [Model.Of(new Ring(Vector3.Zero, new(1, 0, 0), 1, 2))],
        ["plain doubles and ifs"] =
        [
            new Cylinder(new(0, 0, 0.5), 1.5, 3) { Color = new(1, 0.5, 0) },
            Model.Of(new Plane(new(0, 0, -1), new(0, 0, 1))),
            new Cylinder(new(1, -2, 0), 1, 2) { Color = new(0, 0.5, 1) },
        ],
        ["a few with bounds"] = Balls(3),
        ["a batch of those"] = Balls(100),
    };

    public static TheoryData<string> Shapes => [.. models.Keys];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void AreDrawnLikeTheDefinition(string shapes)
    {
        var scene = new Scene(new(new(8, 3, 4), Vector3.Zero) { Width = 79, Height = 53 }, models[shapes], new Color(0, 0, 1));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }

    private static Model[] Balls(int count) => [.. Enumerable.Range(0, count).Select(i => Model.Of(new Ball(new(0, i % 10 - 5, i / 10 - 5), 0.4)))];

    private readonly record struct Ball(Vector3 Center, double Radius) : IPrimitive, IBoundingSphere
    {
        public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => new Sphere(Center, Radius).Intersect(ray);
    }
}
