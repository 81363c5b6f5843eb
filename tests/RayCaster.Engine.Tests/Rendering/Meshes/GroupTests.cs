namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Tests of several consecutive triangles at once give the same results as tests of each triangle.</summary>
public class GroupTests
{
    private static readonly Camera camera = new(new(5, 0.4, 0.3), Vector3.Zero) { FovY = 6, Width = 64, Height = 64 };

    [Theory]
    [InlineData(0, -1)]
    [InlineData(0, int.MinValue)]
    [InlineData(47, 48)]
    [InlineData(49, 54)] // of the last two triangles, which are less than can be checked at once
    [InlineData(53, int.MaxValue)]
    [InlineData(0, 0)] // of no vertices
    public void ACornerThatIsNotThereIsFoundBeforeItIsRead(int place, int index)
    {
        var (vertices, indices) = Specks(18);
        indices[place] = index;
        if (index == 48) vertices = vertices[..48];
        if (index == 0) vertices = [];
        var scene = new Scene(camera, [new Mesh(vertices, indices)]);
        Assert.Throws<IndexOutOfRangeException>(() => new Renderer(scene, 1).CastHits());
    }

    /// <summary>Small triangles about the origin.</summary>
    private static (Vector3[] Vertices, int[] Indices) Specks(int count)
    {
        var random = new Random(count);
        var vertices = new Vector3[3 * count];
        for (var i = 0; i < count; i++)
        {
            Vector3 At(double y, double z) => new(0.01 * random.NextDouble(), 0.05 + 0.01 * i % 0.04 + y, 0.02 + z);
            (vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]) = (At(0, 0), At(0.02, 0), At(0, 0.02));
        }
        return (vertices, [.. Enumerable.Range(0, 3 * count)]);
    }
}
