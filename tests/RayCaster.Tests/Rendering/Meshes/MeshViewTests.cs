namespace RayCaster.Tests.Rendering.Meshes;

/// <summary>The filter for meshes may propose what it likes: what comes out is to the bit what asking all triangles gives.</summary>
public class MeshViewTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    public void RandomMeshesComeOutToTheBit(int seed)
    {
        var rounds = int.Parse(Environment.GetEnvironmentVariable("RAYCASTER_ROUNDS") ?? "60");
        for (var i = 0; i < rounds; i++)
            RendererTests.AssertEqual(RandomMesh.Make(new Random(seed * 100_000 + i)), $"scene {i} of seed {seed}");
    }
}
