namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Data that are kept from frame to frame change no bit of the picture.</summary>
public class LaterFramesTests
{
    [Fact]
    public void FramesThatShareModelsAreThoseOfNewModels()
    {
        var shared = Models();
        Parallel.For(0, 8, i => // the first frames come at the same time
        {
            var camera = new Camera(new(4 * Math.Cos(i), 4 * Math.Sin(i), 1), Vector3.Zero) { Width = 90, Height = 70 };
            var later = new Renderer(new(camera, shared), 2) { ManyFrames = true }.CastHits();
            var alone = new Renderer(new(camera, Models()), 1).CastHits();
            Assert.Equal(alone.T, later.T);
            Assert.Equal(alone.Model, later.Model);
        });
    }

    [Fact]
    public void AModelThatIsAddedToTheListShowsInTheNextFrame()
    {
        var models = Models().ToList();
        var camera = new Camera(new(4, 0, 1), Vector3.Zero) { Width = 90, Height = 70 };
        new Renderer(new(camera, models), 1) { ManyFrames = true }.CastHits();
        models.Add(Model.Of(new Sphere(new(3, 0, 0.75), 0.3)));
        Assert.Contains(models.Count - 1, new Renderer(new(camera, models), 1) { ManyFrames = true }.CastHits().Model);
    }

    /// <summary>A mesh, and so many spheres that they are a batch.</summary>
    private static Model[] Models()
    {
        var (random, ball) = (new Random(1), MeshGenerator.Icosphere(3));
        double Next() => 2 * random.NextDouble() - 1;
        var spheres = Enumerable.Range(0, 100).Select(_ => Model.Of(new Sphere(new(Next(), Next(), 1.5 * Next()), 0.2)));
        return [new Mesh(ball.Vertices, ball.Indices), .. spheres];
    }
}
