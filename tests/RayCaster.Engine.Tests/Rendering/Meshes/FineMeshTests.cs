namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Meshes of many small triangles over many tiles: groups of them are sorted, hidden by nearer ones, and drawn eight at once.</summary>
public class FineMeshTests
{
    [Theory]
    [InlineData(1, Explicit = true)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4, Explicit = true)]
    [InlineData(5)]
    [InlineData(6, Explicit = true)]
    public void SmallTrianglesComeOutToTheBit(int seed)
    {
        var random = new Random(seed);
        var mesh = seed % 2 == 0 ? MeshGenerator.BumpySphere(5) : MeshGenerator.TorusKnot(2, 3, 1, 0.4, 0.2, 300, 16);
        if (seed > 4) Shuffle(mesh.Indices, random);
        var position = (seed % 3 == 0 ? 0.5 : 3) * new Vector3(random.NextDouble() - 0.5, random.NextDouble() - 0.5, 1).Normalized;
        var camera = new Camera(position, new(0.1, 0.2, 0)) { Width = random.Next(150, 400), Height = random.Next(150, 300), ZNear = seed % 2 };
        var scene = new Scene(camera, [new Mesh(mesh.Vertices, mesh.Indices)]);
        var hits = new Renderer(scene, 2).CastHits();
        for (var i = 0; i < 60; i++)
        {
            var (column, row) = (random.Next(camera.Width), random.Next(camera.Height));
            Assert.Equal(ScalarRenderer.Cast(scene, column, row).T, hits.T[(camera.Height - 1 - row) * camera.Width + column]);
        }
    }

    /// <summary>A line range begins within a tile, so what is known of the tile's cells lies elsewhere.</summary>
    [Fact]
    public void SomeLinesOfAMeshAreThoseOfTheWholePicture()
    {
        var mesh = MeshGenerator.BumpySphere(5);
        var scene = new Scene(new(new(3, 2, 1), Vector3.Zero) { Width = 300, Height = 200 }, [new Mesh(mesh.Vertices, mesh.Indices)]);
        var whole = Renderer.Render(scene).Rgb;
        var random = new Random(1);
        for (var i = 0; i < 12; i++)
        {
            var first = random.Next(199);
            var end = random.Next(first, 200) + 1;
            var bytes = new List<byte>();
            new Renderer(scene).Draw(first..end, part => bytes.AddRange(part));
            Assert.Equal(whole[(900 * first)..(900 * end)], bytes.ToArray());
        }
    }

    private static void Shuffle(int[] indices, Random random)
    {
        for (var i = indices.Length / 3 - 1; i > 0; i--)
            for (int j = random.Next(i + 1), k = 0; k < 3; k++)
                (indices[3 * i + k], indices[3 * j + k]) = (indices[3 * j + k], indices[3 * i + k]);
    }
}
