namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Seeded scenes of one mesh each, made to be awkward: edges on rays, slivers, duplicates, cameras inside, clip planes that cut, extreme
/// sizes.</summary>
internal static class RandomMesh
{
    public static Scene Make(Random random) => Some.SceneThatShows(random, random =>
    {
        var (camera, mesh) = MakeParts(random);
        return new Scene(camera, [new Mesh(mesh.Vertices, mesh.Indices)]);
    });

    public static (Camera Camera, MeshData Mesh) MakeParts(Random random)
    {
        var mesh = MakeMesh(random);
        var unit = random.Next(4) == 0 ? Math.Pow(10, random.Next(-30, 40)) : 1;
        var position = random.Next(5) switch
        {
            0 => mesh.Vertices[random.Next(mesh.Vertices.Length)],
            1 => new(random.Next(-2, 3), random.Next(-2, 3), random.Next(-2, 3)),
            2 => Some.Point(random, 0.8),
            _ => Some.Point(random, 6),
        };
        var target = random.Next(4) switch
        {
            0 => position + new Vector3(random.Next(-1, 2), random.Next(-1, 2), 0),
            1 => mesh.Vertices[random.Next(mesh.Vertices.Length)],
            2 => Vector3.Zero,
            _ => Some.Point(random, 1),
        };
        if (!((target - position).Length > 1e-9)) target = position + new Vector3(1, 0, 0);
        var up = Math.Abs((target - position).Normalized.Z) > 0.99 ? new Vector3(0, 1, 0) : new Vector3(0, 0, 1);
        var fovY = random.Next(6) switch { 0 => Math.Pow(10, -12 * random.NextDouble()), 1 => 170, 2 => 90, _ => 10 + 80 * random.NextDouble() };
        var (width, height) = random.Next(12) switch
        {
            0 => (1, 200),
            1 => (200, 1),
            2 => (1, 1),
            3 => (130, 70),
            _ => (random.Next(2, 60), random.Next(2, 60)),
        };
        var zNear = random.Next(3) == 0 ? 4 * random.NextDouble() : random.Next(2) * 0.01;
        var camera = new Camera(unit * position, unit * target)
        {
            Up = up,
            FovY = fovY,
            Width = width,
            Height = height,
            ZNear = unit * zNear,
            ZFar = unit * (zNear + (random.Next(3) == 0 ? 3 : 1000)),
            Bias = random.Next(3) switch { 0 => 0, 1 => 1e-6 * unit, _ => unit * random.NextDouble() },
            Clip = (ClipMode)random.Next(2),
            Sample = (PixelSample)random.Next(2),
        };
        return (camera, new(Array.ConvertAll(mesh.Vertices, p => unit * p), mesh.Indices));
    }

    private static MeshData MakeMesh(Random random)
    {
        switch (random.Next(8))
        {
            case 0: return MeshGenerator.Icosphere(random.Next(4));
            case 1: return MeshGenerator.BumpySphere(random.Next(2, 4), 0.2, 5);
            case 2: return MeshGenerator.Cube(1);
            case 3: return MeshGenerator.TorusKnot(2, 3, 1, 0.4, 0.2, 40, 6);
            case 4: return Crowd(random, 200, Some.Point);
            // coplanar ones, edge-on ones, duplicates, no area
            case 5: return Crowd(random, 200, (r, _) => new(r.Next(-3, 4), r.Next(-3, 4), r.Next(-3, 4)));
            case 6:
                // Needles: two corners next to each other, the third far off.
                var needles = Crowd(random, 100, Some.Point);
                for (var i = 0; i < needles.Indices.Length; i += 3)
                    needles.Vertices[needles.Indices[i + 1]] = needles.Vertices[needles.Indices[i]] +
                        Some.Point(random, Math.Pow(10, -12 * random.NextDouble()));
                return needles;
            default:
                // From tiny to huge, in one mesh.
                return Crowd(random, 200, (r, reach) => Math.Pow(10, 8 * r.NextDouble() - 4) * Some.Point(r, reach));
        }
    }

    private static MeshData Crowd(Random random, int count, Func<Random, double, Vector3> point)
    {
        var vertices = new Vector3[3 * count];
        var indices = new int[3 * count];
        for (var i = 0; i < vertices.Length; i++) (vertices[i], indices[i]) = (point(random, 3), i);
        for (var i = 0; i < count / 4; i++) Array.Copy(vertices, 3 * random.Next(count), vertices, 3 * random.Next(count), random.Next(1, 4));
        for (var i = 0; i < 3 * count; i += 3)
            if (random.Next(2) == 0) // a neighbour that is small or large
                for (var k = 1; k < 3; k++)
                    vertices[i + k] = vertices[i] + 0.1 * (vertices[i + k] - vertices[i]);
        return new(vertices, indices);
    }
}
