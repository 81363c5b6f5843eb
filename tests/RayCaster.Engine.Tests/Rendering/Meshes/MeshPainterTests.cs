namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>A mesh's bytes come from floats where the error bound allows it, and equal those of the exact t.</summary>
public class MeshPainterTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void ThePictureIsThatOfTheExactHits(int seed)
    {
        var random = new Random(seed);
        var mesh = MeshGenerator.BumpySphere(4 + seed / 2);
        var position = (seed == 4 ? 0.3 : 2 + random.NextDouble())
            * new Vector3(random.NextDouble() - 0.5, random.NextDouble() - 0.5, 0.7).Normalized;
        var camera = new Camera(position, new(0.1, 0.2, 0), width: 1003, height: 517, zNear: 0.5, zFar: 0.5 + 2 * random.NextDouble(),
            clip: (ClipMode)(seed % 2));
        var models = new Model[]
        {
            new Mesh(mesh.Vertices, mesh.Indices) { Color = new(random.NextDouble(), 1, 1.5) },
            Model.Of(new Sphere(new(0.9, 0.5, 0.5), 0.4)),
        };
        var scene = new Scene(camera, models[..(1 + seed % 2)], new(0.1, 0.5, 3));
        Picture exact = new(camera.Width, camera.Height), painted = new(camera.Width, camera.Height);
        new Renderer(scene, 2).DrawInto(exact);
        new Renderer(scene, 2) { ManyFrames = true }.DrawInto(painted);
        Assert.True(exact.Rgb.AsSpan().SequenceEqual(painted.Rgb));
    }

    [Fact]
    public void ASureByteIsThatOfAnyWInTheRange()
    {
        if (FloatBytes.IsSupported) Assert.Equal(0, WrongPixels(new Random(1), 1e-5f, (screen, scene) => new(screen, scene, 0)));
    }

    [Fact]
    public void WithoutTheErrorOfLevelsSomeSureBytesAreWrong()
    {
        Assert.SkipWhen(!FloatBytes.IsSupported, "no 256-bit vectors here");
        Assert.Equal(0, WrongPixels(new Random(2), 0, (screen, scene) => new(screen, scene, 0)));
        Assert.NotEqual(0, WrongPixels(new Random(2), 0, (screen, scene) => new(screen, scene, 0) { Error = 0 }));
    }

    /// <summary>How many pixels of some tiles are not in doubt and not what the definition makes of a t whose w is in the range that is
    /// known.</summary>
    private static int WrongPixels(Random random, float spread, Func<ScreenSpace, Scene, MeshPainter> make)
    {
        var camera = new Camera(new(3, 1, 2), Vector3.Zero, fovY: 70, width: 1900, height: 1080);
        var scene = new Scene(camera, [new Mesh([], []) { Color = new(0.9, 1, 0.3) }]);
        var screen = new ScreenSpace(camera);
        var painter = make(screen, scene);
        const int Pixels = Tile.MaxSide * TilePixels.Stride;
        var (front, covered, w, rgb) = (new float[Pixels], new float[Pixels], new double[Pixels], new byte[3 * Pixels]);
        var (wrong, sure) = (0, 0);
        for (var i = 0; i < 200; i++)
        {
            var tile = new PixelRect(random.Next(camera.Width - 64), random.Next(camera.Height - 64), 57 + random.Next(8), 64);
            for (var pixel = 0; pixel < Pixels; pixel++)
            {
                front[pixel] = (float)(0.4 + 3 * random.NextDouble());
                covered[pixel] = front[pixel] * (1 - spread * random.NextSingle());
                w[pixel] = covered[pixel] + (front[pixel] - (double)covered[pixel]) * random.NextDouble();
            }
            painter.Paint(tile, covered, front, null, rgb, 0, 3 * tile.Width);
            var doubts = new HashSet<int>(painter.Doubts.Items.ToArray());
            for (var pixel = 0; pixel < Pixels; pixel++)
            {
                var (row, column) = Math.DivRem(pixel, TilePixels.Stride);
                if (column >= tile.Width || doubts.Contains(pixel)) continue;
                sure++;
                var ray = camera.RayThrough(tile.Column + column, tile.Row + row);
                var t = screen.Unit / (w[pixel] * -(ray.Direction * camera.W));
                var at = 3 * (row * tile.Width + column);
                if (scene.Shade(t, scene.Models[0]).ToBytes() != (rgb[at], rgb[at + 1], rgb[at + 2])) wrong++;
            }
        }
        Assert.True(sure > 200 * 57 * 64 * 0.98);
        return wrong;
    }
}
