namespace RayCaster.Engine.Tests.Rendering;

/// <summary>A fault of the engine is noticed: here a shape that means something else over packets than over one number.</summary>
[Collection(nameof(DefinitionCheckTests))] // Renderer.Disagreed is one for all tests
public sealed class DefinitionCheckTests
{
    private static readonly Scene scene = new(
        new(new(5, 0, 0), Vector3.Zero, width: 30, height: 20), [Model.Of(default(NearerInPackets))]);

    [Fact]
    public void ADrawnPictureThatDiffersFromTheDefinitionIsAnError() =>
        Assert.Throws<EngineDisagreesException>(() => new Renderer(scene).Draw(.., _ => { }));

    [Fact]
    public void APictureInMemoryIsAnErrorToo() => Assert.Throws<EngineDisagreesException>(() => Renderer.Render(scene));

    [Fact]
    public void AProgramThatListensGetsTheDefinitionsPictureAndHits()
    {
        var messages = new List<string>();
        Renderer.Disagreed = messages.Add;
        try
        {
            Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
            Assert.Equal(ScalarRenderer.Cast(scene, 3, 4).HitParameter, new Renderer(scene).CastHits().T[(20 - 1 - 4) * 30 + 3]);
            Assert.Equal(2, messages.Count);
            Assert.StartsWith("column 0, line 0: the engine gives (", messages[0]);
            Assert.StartsWith("column 0, line 0: the engine gives t = ", messages[1]);
        }
        finally
        {
            Renderer.Disagreed = null;
        }
    }

    private readonly record struct NearerInPackets : IPrimitive
    {
        public Crossings<N> Intersect<N>(in Ray<N> ray) where N : struct, IReal<N> => new(typeof(N) == typeof(Scalar) ? 4 : 3);
    }
}

/// <summary>Tests that set what all tests share: no other test runs beside them.</summary>
[CollectionDefinition(nameof(DefinitionCheckTests), DisableParallelization = true)]
public sealed class DefinitionCheckTestsRunAlone;
