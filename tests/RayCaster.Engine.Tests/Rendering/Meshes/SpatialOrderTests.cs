using System.Globalization;
using System.Runtime.CompilerServices;

namespace RayCaster.Engine.Tests.Rendering.Meshes;

public class SpatialOrderTests
{
    private const int Side = 300; // 178,802 triangles

    private static readonly Mesh shuffled = Shuffled(Sheet());

    [Fact]
    public void TheLimitsSayFromHowManyTrianglesOnAndWhatTheCopyTakes()
    {
        var limits = File.ReadAllText(ProjectFolder.PathOf("docs/limits.md")).ReplaceLineEndings(" ");
        var (triangle, vertex) = (3 * sizeof(int), Unsafe.SizeOf<Vector3>());
        Assert.Contains(string.Create(CultureInfo.InvariantCulture, $"at least {SpatialOrder.FewTriangles:N0} triangles in random order"), limits);
        Assert.Contains($"{triangle} bytes for each triangle and {vertex} for each vertex", limits);
        Assert.Contains($"{triangle + vertex / 2} bytes a triangle on a closed surface, {triangle + 3 * vertex} where", limits);
    }

    [Fact]
    public void AMeshInRandomOrderKeepsItsTrianglesWithTheirCornersInOrder()
    {
        var sorted = SpatialOrder.Of(shuffled);
        Assert.Equal(shuffled.TriangleCount, sorted.TriangleCount);
        Assert.True(TrianglesOf(shuffled).SetEquals(TrianglesOf(sorted))); // no two of them are equal
    }

    [Fact]
    public void ItIsSortedOnceAndStaysAsItWas()
    {
        var indices = shuffled.Indices.ToArray();
        Assert.Same(SpatialOrder.Of(shuffled), SpatialOrder.Of(shuffled));
        Assert.Equal(indices, shuffled.Indices);
    }

    [Fact]
    public void APictureOfTrianglesInRandomOrderIsTheDefinitions()
    {
        var mesh = new Mesh(shuffled.Vertices, shuffled.Indices) { Color = new(0.9, 0.2, 0.3) };
        var scene = new Scene(new(new(0.5, -1, 2), new(0.5, 0.5, 0)) { Width = 9, Height = 5 }, [Model.Of(new Sphere(new(0, 0, 0), 0.1)), mesh]);
        Assert.Equal(ScalarRenderer.Render(scene).Rgb, Renderer.Render(scene).Rgb);
    }

    private static HashSet<Triangle> TrianglesOf(Mesh mesh) => [.. Enumerable.Range(0, mesh.TriangleCount).Select(i => mesh[i])];

    /// <summary>A wavy sheet, row by row.</summary>
    private static Mesh Sheet()
    {
        var vertices = new Vector3[Side * Side];
        var indices = new List<int>();
        for (var i = 0; i < vertices.Length; i++)
        {
            double x = i % Side / (double)Side, y = i / Side / (double)Side;
            vertices[i] = new(x, y, 0.1 * Math.Sin(20 * x) * Math.Sin(20 * y));
            if (i % Side > 0 && i >= Side) indices.AddRange([i, i - 1, i - Side, i - 1, i - Side - 1, i - Side]);
        }
        return new(vertices, [.. indices]);
    }

    private static Mesh Shuffled(Mesh mesh)
    {
        var random = new Random(20261122);
        var (places, triangles) = (Enumerable.Range(0, mesh.Vertices.Length).ToArray(), Enumerable.Range(0, mesh.TriangleCount).ToArray());
        random.Shuffle(places);
        random.Shuffle(triangles);
        var vertices = new Vector3[places.Length];
        for (var i = 0; i < places.Length; i++) vertices[places[i]] = mesh.Vertices[i];
        return new(vertices, [.. triangles.SelectMany(t => mesh.Indices[(3 * t)..(3 * t + 3)]).Select(index => places[index])]);
    }
}
