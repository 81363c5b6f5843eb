namespace RayCaster.Engine.Tests.Rendering;

/// <summary>A fault of the engine is noticed: here a shape that means something else over packets than over one number.</summary>
public sealed class DefinitionCheckTests
{
    private static readonly Scene scene = new(
        new(new(5, 0, 0), Vector3.Zero) { Width = 30, Height = 20 }, [Model.Of(default(NearerInPackets))]);

    [Fact]
    public void WhoDrawsAPictureThatDiffersFromTheDefinitionIsToldWhere() =>
        Assert.Matches(@"^column \d+, line \d+: the engine gives \(", new Renderer(scene).Draw(.., _ => { }));

    [Fact]
    public void APictureOrAMapInMemoryIsAnError()
    {
        var error = Assert.Throws<EngineDisagreesException>(() => Renderer.Render(scene));
        Assert.Matches(@" at column \d+, line \d+: the engine gives \(", error.Message);
        error = Assert.Throws<EngineDisagreesException>(() => new Renderer(scene).CastHits());
        Assert.Matches(@" at column \d+, line \d+: the engine gives Hit ", error.Message);
    }

    /// <summary>Pictures that lack one triangle in a hundred: through the holes the mesh's other side shows.</summary>
    [Theory]
    [InlineData(4, 640, 480)]
    [InlineData(5, 1280, 720, Explicit = true)]
    [InlineData(6, 1280, 720, Explicit = true)]
    public void AFaultInOneTriangleOfAHundredIsNoticedInNineteenPicturesOfTwenty(int subdivisions, int width, int height)
    {
        var noticed = 0;
        for (var i = 0; i < 20; i++)
        {
            var random = new Random(i);
            var mesh = MeshGenerator.BumpySphere(subdivisions);
            var indices = (int[])mesh.Indices.Clone();
            for (var triangle = random.Next(100); triangle < indices.Length / 3; triangle += 100) indices[3 * triangle + 1] = indices[3 * triangle];
            var camera = new Camera(3.2 * Some.Direction(random), Vector3.Zero) { Width = width, Height = height };
            var picture = Renderer.Render(new(camera, [new Mesh(mesh.Vertices, indices)]));
            var check = new DefinitionCheck(new(camera, [new Mesh(mesh.Vertices, mesh.Indices)]), 0, height, threads: 1);
            check.RunAlongside(() => check.Sample(picture.Rgb), threads: 1);
            if (check.Difference() is not null) noticed++;
        }
        Assert.InRange(noticed, 19, 20);
    }

    private readonly record struct NearerInPackets : IPrimitive
    {
        public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => new(typeof(N) == typeof(Scalar) ? 4 : 3);
    }
}
