namespace RayCaster.Benchmarks;

/// <summary>Meshes that are hard for one way or another of finding the nearest triangle. All but the slivers are made of bumpy spheres.</summary>
internal static class OddMeshes
{
    private const int Layers = 100;

    /// <summary>What names of scenes begin with.</summary>
    public static readonly string[] Kinds = ["inside", "layers", "slivers", "shuffled"];

    public static BenchmarkScene Make(string name, string kind, int count)
    {
        var mesh = kind switch
        {
            "layers" => Nested(BenchmarkScene.BumpyMesh(BenchmarkScene.BandsFor(count / Layers))),
            "slivers" => Slivers(count),
            "shuffled" => Shuffled(BenchmarkScene.BumpyMesh(BenchmarkScene.BandsFor(count))),
            _ => BenchmarkScene.BumpyMesh(BenchmarkScene.BandsFor(count)),
        };
        var number = Text.Count(mesh.Indices.Length / 3);
        return kind switch
        {
            "inside" => BenchmarkScene.Of(name, $"{number} triangles around the camera", mesh, CameraInside),
            "layers" => BenchmarkScene.Of(name, $"{Layers} spheres in each other, {number} triangles", mesh, BenchmarkScene.CameraAt),
            "slivers" => BenchmarkScene.Of(name, $"{number} long thin triangles", mesh, BenchmarkScene.CameraAt),
            _ => BenchmarkScene.Of(name, $"{number} triangles in random order", mesh, BenchmarkScene.CameraAt),
        };
    }

    private static Camera CameraInside(int width, int height) =>
        new(new(0, 0.001, 0.002), new(-1, 0, 0), width: width, height: height, zNear: 0.125, zFar: 65536);

    /// <summary>A mesh and smaller and smaller copies in it, each in another direction, down to half of its size.</summary>
    private static MeshData Nested(MeshData one)
    {
        var (vertices, indices) = (new List<Vector3>(), new List<int>());
        for (var i = 0; i < Layers; i++)
        {
            var (size, first) = (1 - 0.5 * i / Layers, vertices.Count);
            vertices.AddRange(one.Vertices.Select(v => new Vector3((float)(size * v.X), (float)(size * v.Y), (float)(size * v.Z))));
            indices.AddRange(one.Indices.Select(index => index + first));
        }
        return new([.. vertices], [.. indices]);
    }

    /// <summary>Triangles across a cube of side 2, in all directions; seeded.</summary>
    private static MeshData Slivers(int count)
    {
        var random = new Random(20261122);
        Vector3 Point(double size) => new(Number(size), Number(size), Number(size));
        double Number(double size) => (float)(size * (2 * random.NextDouble() - 1));
        var vertices = new Vector3[3 * count];
        for (var i = 0; i < vertices.Length; i += 3)
        {
            var a = Point(1);
            (vertices[i], vertices[i + 1], vertices[i + 2]) = (a, Point(1), a + Point(0.001));
        }
        return new(vertices, [.. Enumerable.Range(0, vertices.Length)]);
    }

    /// <summary>The same mesh, vertices and triangles in random order, as a scanner's software writes them; seeded.</summary>
    private static MeshData Shuffled(MeshData mesh)
    {
        var random = new Random(20261122);
        var (places, triangles) = (Enumerable.Range(0, mesh.Vertices.Length).ToArray(), mesh.Indices.Chunk(3).ToArray());
        random.Shuffle(places);
        random.Shuffle(triangles);
        var vertices = new Vector3[places.Length];
        for (var i = 0; i < places.Length; i++) vertices[places[i]] = mesh.Vertices[i];
        return new(vertices, [.. triangles.SelectMany(corners => corners).Select(index => places[index])]);
    }
}
