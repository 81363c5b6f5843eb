namespace RayCaster.Tests.Rendering;

/// <summary>The fast renderer answers to the bit what the definition answers: which model, and at which t.</summary>
public class RendererTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void RandomScenesComeOutToTheBit(int seed)
    {
        for (var i = 0; i < 50; i++)
        {
            var random = new Random(seed * 1000 + i);
            AssertEqual(RandomScene.Make(random), $"scene {i} of seed {seed}");
        }
    }

    [Fact]
    public void ThePictureDoesNotDependOnTheNumberOfThreads()
    {
        var scene = RandomScene.Make(new Random(42));
        scene = scene with { Camera = scene.Camera.WithSize(301, 199) };
        var alone = Renderer.Render(scene, threads: 1).Rgb;
        Assert.Equal(alone, Renderer.Render(scene, threads: 2).Rgb);
        Assert.Equal(alone, Renderer.Render(scene, threads: 7).Rgb);
        Assert.Equal(alone, ScalarRenderer.Render(scene).Rgb);
    }

    [Theory]
    [InlineData(1, 1)]
    [InlineData(1, 3000)]
    [InlineData(3000, 1)]
    [InlineData(65, 3)]
    public void PicturesOfAnyShapeAreDrawnInParts(int width, int height)
    {
        var scene = RandomScene.Make(new Random(5));
        scene = scene with { Camera = scene.Camera.WithSize(width, height) };
        var bytes = new List<byte>();
        var lines = 0;
        new Renderer(scene).Draw(part => bytes.AddRange(part), () => Interlocked.Increment(ref lines));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, bytes);
        Assert.Equal(height, lines);
    }

    [Fact]
    public void OfEqualHitsTheFirstModelShows()
    {
        Scene With(params Model[] models) => new(new Camera(new(5, 0, 0), Vector3.Zero, width: 9, height: 9), models);
        var plane = new Plane(Vector3.Zero, new(1, 0, 0));
        Model red = Model.Of(plane), blue = Model.Of(plane);
        (red.Color, blue.Color) = (new(1, 0, 0), new(0, 0, 1));
        Assert.Equal((byte)0, Renderer.Render(With(red, blue))[4, 4].B);
        Assert.Equal((byte)0, Renderer.Render(With(blue, red))[4, 4].R);
    }

    [Fact]
    public void CancellingStopsTheWork()
    {
        var scene = RandomScene.Make(new Random(5));
        using var cancellation = new CancellationTokenSource();
        var renderer = new Renderer(scene with { Camera = scene.Camera.WithSize(500, 100000) });
        Assert.Throws<OperationCanceledException>(() => renderer.Draw(_ => cancellation.Cancel(), null, cancellation.Token));
    }

    /// <summary>Model and bits of t of every pixel.</summary>
    internal static void AssertEqual(Scene scene, string what)
    {
        var camera = scene.Camera;
        var renderer = new Renderer(scene);
        var span = new RaySpan(camera);
        for (var row = 0; row < camera.Height; row++)
        {
            for (var column = 0; column < camera.Width; column += RaySpan.MaxLength)
            {
                var length = Math.Min(RaySpan.MaxLength, camera.Width - column);
                renderer.Cast(span, column, row, length);
                for (var i = 0; i < length; i++)
                {
                    var ray = ScalarRenderer.Cast(scene, column + i, row);
                    var fast = span.ModelAt(i) < 0 ? null : scene.Models[span.ModelAt(i)];
                    if (fast == ray.HitModel && span.T[i].Equals(ray.HitParameter)) continue;
                    Assert.Fail($"{what}: column {column + i}, row {row}: the definition hits {ray.HitModel?.Name ?? "nothing"} at {ray.HitParameter:R}, " +
                        $"the renderer {fast?.Name ?? "nothing"} at {span.T[i]:R}");
                }
            }
        }
    }
}
