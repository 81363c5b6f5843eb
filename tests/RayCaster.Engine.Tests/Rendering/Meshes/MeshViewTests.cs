namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>The filter for meshes only proposes triangles: the result equals that of intersecting all triangles, to the bit.</summary>
public class MeshViewTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void RandomMeshesComeOutToTheBit(int seed) =>
        RendererTests.AssertEqual(seed, RandomMesh.Make, int.Parse(Environment.GetEnvironmentVariable("RAYCASTER_ROUNDS") ?? "10"));

    /// <summary>Triangles in planes that contain the camera, except in the last bits; the definition's t is anywhere that they span.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    public void TrianglesSeenEdgeOnComeOutToTheBit(int seed)
    {
        var random = new Random(seed);
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero) { FovY = 40, Width = 64, Height = 64 };
        var vertices = new List<Vector3>();
        for (var i = 0; i < 200; i++)
        {
            var (a, b) = (0.01 * random.Next(-100, 100), 0.01 * random.Next(-100, 100));
            Vector3 At(double x, double s) => camera.Position + (x + 5) * new Vector3(1, s * a, s * b);
            vertices.AddRange(
                [At(random.NextDouble(), 0.3), At(random.NextDouble(), 0.1), At(random.NextDouble(), 0.3 + 1e-9 * random.NextDouble())]);
        }
        vertices.AddRange([new(0.5, -9, -9), new(0.5, 9, -9), new(0.5, 0, 9)]);
        RendererTests.AssertEqual(new(camera, [new Mesh([.. vertices], [.. Enumerable.Range(0, vertices.Count)])]), $"seed {seed}");
    }

    [Fact]
    public void ManyTrianglesInOnePlaceComeOutToTheBit()
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero) { Width = 12, Height = 9 };
        Vector3[] corners = [new(0, -1, -1), new(0, 1, -1), new(0.1, 0, 1)];
        RendererTests.AssertEqual(new(camera, [new Mesh(corners, [.. Enumerable.Range(0, 30_000).Select(i => (i + i / 3) % 3)])]), "duplicates");
    }

    /// <summary>There are fewer filters than meshes, so meshes share them.</summary>
    /// <param name="spheres">With so many as 70 they are found as a batch.</param>
    [Theory]
    [InlineData(0)]
    [InlineData(3)]
    [InlineData(70)]
    public void AHundredMeshesInATileComeOutToTheBit(int spheres)
    {
        var random = new Random(1);
        var ball = MeshGenerator.Icosphere(0);
        var models = new List<Model>();
        for (var i = 0; i < 100; i++)
        {
            var center = Some.Point(random, 1);
            models.Add(new Mesh([.. ball.Vertices.Select(vertex => center + 0.15 * vertex)], ball.Indices) { Color = new(i / 100.0, 1, 0) });
        }
        for (var i = 0; i < spheres; i++) models.Insert(random.Next(models.Count), Model.Of(new Sphere(Some.Point(random, 1), 0.1)));
        if (spheres > 0) models.AddRange([Model.Of(new Plane(new(0.5, 0, 0), new(1, 0.2, 0))), new Cylinder(new(0, 0.5, 0), 0.3, 1)]);
        RendererTests.AssertEqual(new(new(new(-5, 0, 0), Vector3.Zero) { FovY = 25, Width = 90, Height = 70 }, models), "a hundred meshes");
    }
}
