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
        var camera = new Camera(position, new(0.1, 0.2, 0))
        {
            Width = 503,
            Height = 317,
            ZNear = 0.5,
            ZFar = 0.5 + 2 * random.NextDouble(),
            Clip = (ClipMode)(seed % 2),
        };
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
}
