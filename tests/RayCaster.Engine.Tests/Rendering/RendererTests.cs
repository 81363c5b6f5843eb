namespace RayCaster.Engine.Tests.Rendering;

/// <summary>The fast renderer gives the same model and the same bits of t as the definition.</summary>
public class RendererTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void RandomScenesComeOutToTheBit(int seed) => AssertEqual(seed, RandomScene.Make, ScenesOfASeed);

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void RandomCrowdsComeOutToTheBit(int seed) => AssertEqual(seed, random => RandomCrowd.Make(random), ScenesOfASeed);

    /// <summary>Where the coordinates are much larger than the things, whatever is rounded before the camera's position is subtracted loses
    /// hits.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1e3)]
    [InlineData(1e5)]
    [InlineData(4e6)] // metres of a map
    [InlineData(1e8)]
    [InlineData(1e10)]
    [InlineData(1e12)]
    public void CrowdsFarFromTheOriginComeOutToTheBit(double distance) =>
        AssertEqual(5, random => RandomCrowd.Make(random, distance), ScenesOfASeed);

    /// <summary>So few models that each is drawn by itself.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(4e6)]
    [InlineData(1e8)]
    [InlineData(1e12)]
    public void SomeModelsFarFromTheOriginComeOutToTheBit(double distance) =>
        AssertEqual(6, random => RandomCrowd.Make(random, distance, least: 8), 4 * ScenesOfASeed);

    /// <summary>Compares random scenes; fails if most pictures show only one thing.</summary>
    internal static void AssertEqual(int seed, Func<Random, Scene> make, int count)
    {
        var empty = 0;
        for (var i = 0; i < count; i++)
            if (AssertEqual(make(Some.Chance(seed * 1_000_000 + i)), $"scene {i} of row {seed}, RAYCASTER_SEED={Campaign.Seed}") < 2) empty++;
        Assert.True(empty <= 0.3 * count, $"{empty} of {count} scenes show less than two models: they test little");
    }

    /// <summary>A sample; .ci/run and longer campaigns set RAYCASTER_SCENES.</summary>
    private static int ScenesOfASeed =>
        int.TryParse(Environment.GetEnvironmentVariable("RAYCASTER_SCENES"), out var scenes) ? scenes / 4 : 6;

    [Fact]
    public void ThePictureDoesNotDependOnTheNumberOfThreads()
    {
        var scene = RandomScene.Make(new Random(42));
        scene = scene.WithSize(301, 199);
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
    [InlineData(65, 130)]
    public void PicturesOfAnyShapeAreDrawnInParts(int width, int height)
    {
        var scene = RandomScene.Make(new Random(5));
        scene = scene.WithSize(width, height);
        var bytes = new List<byte>();
        var lines = 0;
        new Renderer(scene).Draw(.., part => bytes.AddRange(part), done => Interlocked.Add(ref lines, done));
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, bytes.ToArray());
        Assert.Equal(height, lines);
    }

    /// <summary>So wide that a row of tiles is drawn in halves, and with triangles that are smaller than a pixel.</summary>
    [Fact(Explicit = true)]
    public void AVeryWidePictureOfAMeshIsRightInAllItsBands()
    {
        var scene = SceneReader.Read(ProjectFolder.PathOf("scenes/mesh.json")).Scene!.WithSize(90_000, 70);
        var middle = (90_000 - 24) / 2; // where the mesh is
        var bytes = new List<byte>();
        new Renderer(scene).Draw(.., part => bytes.AddRange(part));
        for (var y = 0; y < 70; y++)
            for (var x = middle; x < middle + 24; x++)
            {
                var at = 3 * (y * 90_000 + x);
                Assert.Equal(ScalarRenderer.Pixel(scene, x, y), (bytes[at], bytes[at + 1], bytes[at + 2]));
            }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void SomeLinesAreThoseOfTheWholePicture(int seed)
    {
        var random = new Random(seed);
        for (var i = 0; i < 40; i++)
        {
            var scene = RandomScene.Make(random);
            scene = scene.WithSize(random.Next(1, 150), random.Next(1, 300));
            var (width, height, whole) = (scene.Camera.Width, scene.Camera.Height, Renderer.Render(scene).Rgb);
            var first = random.Next(height);
            var end = random.Next(first, height) + 1;
            var bytes = new List<byte>();
            new Renderer(scene).Draw(first..end, part => bytes.AddRange(part));
            Assert.Equal(whole[(3 * width * first)..(3 * width * end)], bytes.ToArray());
        }
    }

    [Theory]
    [InlineData(3, 3)]
    [InlineData(0, 11)]
    [InlineData(11, 12)]
    public void LinesBeyondThePictureAreRefused(int first, int end)
    {
        var scene = RandomScene.Make(new Random(1));
        var renderer = new Renderer(scene.WithSize(5, 10));
        Assert.Throws<ArgumentOutOfRangeException>(() => renderer.Draw(first..end, _ => { }));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void ManyModelsComeOutToTheBit(int seed)
    {
        var random = new Random(seed);
        var models = new List<Model>();
        while (models.Count < 600)
        {
            var (place, size) = (Some.Point(random, 4), random.Next(40) == 0 ? 3 : 0.05 + 0.3 * random.NextDouble());
            var corner = new Vector3(size, size / 2, size);
            models.Add(random.Next(4) switch
            {
                0 => Model.Of(new Aabb(place - corner, place + corner)),
                1 => Model.Of(new Circle(place, new(Some.Number(random, 1), Some.Number(random, 1), 0.1), size)),
                2 => Model.Of(new Triangle(place, place + corner, place + new Vector3(-size, size, Some.Number(random, 1)))),
                _ => Model.Of(new Sphere(place, size)),
            });
            if (random.Next(10) == 0) models.Add(Model.Of(new Sphere(place, size))); // ties, and behind each other in the file
        }
        models.Insert(random.Next(models.Count), Model.Of(new Plane(new(0, 0, -4), new(0, 0, 1))));
        var position = Some.Point(random, 9);
        var camera = new Camera(position, new(0.1, 0, 0)) { Width = 100, Height = 83, Sample = (PixelSample)(seed % 2) };
        AssertEqual(new Scene(camera, models), $"seed {seed}");
    }

    /// <summary>Large enough for parts of all sizes that one model covers, and for bytes that floats leave in doubt.</summary>
    [Theory]
    [InlineData(20, 0, 0, 45)]
    [InlineData(9, -3, 2, 70)]
    public void TheRoomComesOutToTheBit(double x, double y, double z, double fovY)
    {
        var room = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;
        var camera = room.Camera with { Width = 700, Height = 333, Position = new(x, y, z), Target = Vector3.Zero, FovY = fovY };
        AssertEqual(room with { Camera = camera, Background = new(0.2, 0.4, 2) },
            "the room");
    }

    /// <summary>
    /// Up so nearly along the view that U, V and W are not at right angles, by rounding: rays then pass beside the pixels on which U and V put
    /// what they hit.
    /// </summary>
    [Theory]
    [InlineData(40)]
    [InlineData(200)]
    public void AViewAlmostAlongUpComesOutToTheBit(int spheres)
    {
        var random = new Random(spheres);
        for (var i = 0; i < 4; i++)
        {
            var models = new List<Model>();
            while (models.Count < spheres)
                models.Add(Model.Of(new Sphere(Some.Point(random, 0.015), 0.0002 + 0.001 * random.NextDouble())));
            var (position, target) = (new Vector3(Some.Number(random, 2), Some.Number(random, 2), 9 + Some.Number(random, 1)), Vector3.Zero);
            var up = (position - target).Normalized + 3e-12 * Some.Point(random, 1);
            var camera = new Camera(position, target) { Up = up, FovY = 0.2, Width = 150, Height = 150 };
            if (camera.ValidationError is null) AssertEqual(new Scene(camera, models), $"picture {i}");
        }
    }

    [Fact]
    public void OfEqualHitsTheFirstModelShows()
    {
        Scene With(params Model[] models) => new(new Camera(new(5, 0, 0), Vector3.Zero) { Width = 9, Height = 9 }, models);
        var plane = new Plane(Vector3.Zero, new(1, 0, 0));
        Model red = Model.Of(plane), blue = Model.Of(plane);
        (red.Color, blue.Color) = (new(1, 0, 0), new(0, 0, 1));
        Assert.Equal((byte)0, Renderer.Render(With(red, blue))[4, 4].B);
        Assert.Equal((byte)0, Renderer.Render(With(blue, red))[4, 4].R);
    }

    [Theory]
    [InlineData(500, 100000)]
    [InlineData(10, 200)]
    public void CancellingStopsTheWork(int width, int height)
    {
        var scene = RandomScene.Make(new Random(5));
        using var cancellation = new CancellationTokenSource();
        var renderer = new Renderer(scene.WithSize(width, height));
        Assert.Throws<OperationCanceledException>(() => renderer.Draw(.., _ => cancellation.Cancel(), null, cancellation.Token));
    }

    [Fact]
    public void CancellingStopsTheWorkBetweenStrips()
    {
        using var cancellation = new CancellationTokenSource();
        var watched = new Watched(Model.Of(new Sphere(Vector3.Zero, 1)), _ => cancellation.Cancel());
        var camera = new Camera(new(5, 0, 0), Vector3.Zero) { Width = 600, Height = 600 };
        var renderer = new Renderer(new(camera, [watched]), threads: 1);
        Assert.Throws<OperationCanceledException>(() => renderer.CastHits(null, cancellation.Token));
        Assert.Throws<OperationCanceledException>(() => renderer.DrawInto(new Picture(600, 600), cancellation.Token));
        Assert.InRange(watched.Rays.Count, 1, Tile.MaxStrip * Tile.MaxSide);
    }

    /// <summary>Such a camera's pixels are so close together that a mesh gets a hierarchy of boxes.</summary>
    [Theory]
    [InlineData(45)]
    [InlineData(1e-11)]
    public void CancellingStopsThePreparationOfAMesh(double fovY)
    {
        var mesh = MeshGenerator.Icosphere(3);
        var camera = new Camera(new(5, 0, 0), Vector3.Zero) { FovY = fovY, Width = 1, Height = 1 };
        var screen = new ScreenSpace(camera);
        Assert.Equal(fovY > 1, screen.IsFine);
        Assert.Throws<OperationCanceledException>(() => new MeshView<Packet>(new Mesh(mesh.Vertices, mesh.Indices), screen, new(true)));
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-1)]
    public void LessThanOneThreadIsRefused(int threads) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new Renderer(RandomScene.Make(new Random(1)), threads));

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void AnErrorOfAShapeKeepsTheStackOfItsThread(int threads)
    {
        var faulty = new Watched(Model.Of(new Sphere(Vector3.Zero, 1)), _ => throw new InvalidOperationException());
        var camera = new Camera(new(5, 0, 0), Vector3.Zero) { Width = 600, Height = 600 };
        var error = Assert.Throws<InvalidOperationException>(() => new Renderer(new(camera, [faulty]), threads).Draw(.., _ => { }));
        Assert.Contains(nameof(Watched), error.StackTrace);
    }

    /// <summary>A scalar shape that keeps the rays that it was intersected with.</summary>
    private sealed class Watched(Model shape, Action<Ray>? watch = null) : Model
    {
        public HashSet<Ray> Rays { get; } = new(ReferenceEqualityComparer.Instance);

        public override Bounds? Bounds => shape.Bounds;

        public override double? Intersect(Ray ray)
        {
            Rays.Add(ray);
            watch?.Invoke(ray);
            return shape.Intersect(ray);
        }
    }

    /// <summary>Floats cannot tell which of two planes is in front that lie some millionths apart, and neither can a byte wait for doubles to be
    /// asked everywhere.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1e-7)]
    [InlineData(1e-6)]
    [InlineData(1e-4)]
    public void PlanesThatNearlyCoincideKeepTheirColors(double tilt)
    {
        var red = Model.Of(new Plane(new(-5, 0, 0), new(1, 0, 0)));
        var blue = Model.Of(new Plane(new(-5, 0, 0), new(1, tilt, tilt / 3)));
        (red.Color, blue.Color) = (new(1, 0, 0), new(0, 0, 1));
        var camera = new Camera(new(20, 1, 0), new(0, 0.5, 0.3)) { Width = 256, Height = 100 };
        AssertEqual(new Scene(camera, [red, blue]), $"planes at an angle of {tilt}");
    }

    /// <summary>Compares the model, the bits of t and the bytes of every pixel, with and without the kernels for many frames.</summary>
    /// <returns>How many models show; the background counts as one.</returns>
    internal static int AssertEqual(Scene scene, string what)
    {
        var definition = new Hit[scene.Camera.Height, scene.Camera.Width];
        for (var row = 0; row < scene.Camera.Height; row++)
            for (var column = 0; column < scene.Camera.Width; column++)
                definition[row, column] = ScalarRenderer.Cast(scene, column, row);
        AssertEqual(scene, definition, new Renderer(scene, threads: 1), what);
        AssertEqual(scene, definition, new Renderer(scene) { ManyFrames = true }, $"{what}, one of many frames");
        return definition.Cast<Hit>().DistinctBy(hit => hit.Model).Count();
    }

    private static void AssertEqual(Scene scene, Hit[,] definition, Renderer renderer, string what)
    {
        var hits = renderer.CastHits();
        var picture = new Picture(hits.Width, hits.Height);
        renderer.DrawInto(picture);
        for (var line = 0; line < hits.Height; line++)
        {
            for (var column = 0; column < hits.Width; column++)
            {
                var row = hits.Height - 1 - line;
                var (expected, hit) = (definition[row, column], hits[column, line]);
                var bytes = scene.Shade(expected).ToBytes();
                if (hit == expected && picture[column, line] == bytes) continue;
                Assert.Fail($"{what}: column {column}, row {row}: the definition gives {expected}, the renderer {hit}; " +
                    $"bytes {bytes} and {picture[column, line]}");
            }
        }
    }
}
