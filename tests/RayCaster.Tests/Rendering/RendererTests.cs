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
        for (var i = 0; i < ScenesOfASeed; i++) AssertEqual(RandomScene.Make(new Random(seed * 1_000_000 + i)), $"scene {i} of seed {seed}");
    }

    /// <summary>A sample; a long campaign sets RAYCASTER_SCENES (docs/performance.md).</summary>
    private static int ScenesOfASeed =>
        int.TryParse(Environment.GetEnvironmentVariable("RAYCASTER_SCENES"), out var scenes) ? scenes / 4 : 50;

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
        new Renderer(scene).Draw(part => bytes.AddRange(part), done => Interlocked.Add(ref lines, done));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, bytes);
        Assert.Equal(height, lines);
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void ManyModelsComeOutToTheBit(int seed)
    {
        var random = new Random(seed);
        double Next(double range) => range * (2 * random.NextDouble() - 1);
        var models = new List<Model>();
        while (models.Count < 600)
        {
            var (place, size) = (new Vector3(Next(4), Next(4), Next(4)), random.Next(40) == 0 ? 3 : 0.05 + 0.3 * random.NextDouble());
            var corner = new Vector3(size, size / 2, size);
            models.Add(random.Next(4) switch
            {
                0 => Model.Of(new Aabb(place - corner, place + corner)),
                1 => Model.Of(new Circle(place, new(Next(1), Next(1), 0.1), size)),
                2 => Model.Of(new Triangle(place, place + corner, place + new Vector3(-size, size, Next(1)))),
                _ => Model.Of(new Sphere(place, size)),
            });
            if (random.Next(10) == 0) models.Add(Model.Of(new Sphere(place, size))); // ties, and behind each other in the file
        }
        models.Insert(random.Next(models.Count), Model.Of(new Plane(new(0, 0, -4), new(0, 0, 1))));
        var position = new Vector3(Next(9), Next(9), Next(9));
        AssertEqual(new Scene(new Camera(position, new(0.1, 0, 0), width: 150, height: 131, sample: (Sample)(seed % 2)), models), $"seed {seed}");
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

    /// <summary>Model, bits of t and bytes of every pixel.</summary>
    internal static void AssertEqual(Scene scene, string what)
    {
        var hits = new Renderer(scene).CastHits();
        Assert.Equal(hits.T, new Renderer(scene, threads: 1).CastHits().T);
        var picture = Renderer.Render(scene);
        for (var line = 0; line < hits.Height; line++)
        {
            for (var column = 0; column < hits.Width; column++)
            {
                var row = hits.Height - 1 - line;
                var ray = ScalarRenderer.Cast(scene, column, row);
                var (t, index) = (hits.T[line * hits.Width + column], hits.Model[line * hits.Width + column]);
                var model = index < 0 ? null : scene.Models[index];
                var bytes = scene.Shade(ray.HitParameter, ray.HitModel).ToBytes();
                if (model == ray.HitModel && t.Equals(ray.HitParameter) && picture[column, line] == bytes) continue;
                Assert.Fail($"{what}: column {column}, row {row}: the definition hits {ray.HitModel?.Name ?? "nothing"} at {ray.HitParameter:R}, " +
                    $"the renderer {model?.Name ?? "nothing"} at {t:R}; bytes {bytes} and {picture[column, line]}");
            }
        }
    }
}
