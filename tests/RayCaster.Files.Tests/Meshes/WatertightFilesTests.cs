using System.Globalization;

namespace RayCaster.Files.Tests.Meshes;

/// <summary>
/// A closed mesh has no hole in whatever file it comes and wherever a scene puts it. A sample; <c>RAYCASTER_RAYS=20000</c> is the number
/// of rays for each mesh in each place (docs/accuracy.md).
/// </summary>
public class WatertightFilesTests(ITestOutputHelper output)
{
    private static readonly int count =
        int.Parse(Environment.GetEnvironmentVariable("RAYCASTER_RAYS") ?? "40", CultureInfo.InvariantCulture);

    private static readonly (string Name, MeshData Data)[] round =
        [("cube", MeshGenerator.Cube(1)), ("icosphere 320", MeshGenerator.Icosphere(2))];

    private static readonly (string Name, MeshData Data) knot =
        ("knot 240", MeshGenerator.TorusKnot(2, 3, 1.9, 0.75, 0.4, rings: 20, sides: 6));

    private static readonly Dictionary<string, MeshPlacement> placements = new()
    {
        ["as it is"] = new(new(1, 1, 1), default, default),
        ["turned, mirrored, stretched, moved"] = new(new(-1, 2, 0.5), new(10, 20, 30), new(3, -4, 5)),
        ["1e-30"] = new(new(1e-30, 2e-30, 1e-30), new(10, 20, 30), default),
        ["1e40"] = new(new(1e40, 1e40, 2e40), new(10, 20, 30), new(1e41, 0, 0)),
        ["1e8 sizes away"] = new(new(1, 1, 1), new(10, 20, 30), new(1e8, -2e8, 3e7)),
        ["small and away"] = new(new(1e-6, 1e-6, 1e-6), new(10, 20, 30), new(100, -50, 30)),
        ["flattened to a millionth"] = new(new(1, 1, 1e-6), new(10, 20, 30), new(1, 2, 3)),
    };

    /// <summary>The formats that round; all read what was written (<see cref="FormatsTests"/>).</summary>
    private static readonly Dictionary<string, Func<MeshData, MeshData>> formats = new()
    {
        ["obj of six places"] = data => MeshBytes.Read("a.obj", MeshWriter.Obj(data, "F6")),
        ["ply of floats"] = data => MeshBytes.Read("a.ply", MeshWriter.PlyFloat(data)),
    };

    public static TheoryData<string> Formats => [.. formats.Keys];

    /// <summary>Towards corners, middles of edges, other points of edges, points of faces, and anywhere.</summary>
    [Theory]
    [MemberData(nameof(Formats))]
    public void FromInsideEveryRayHits(string format) => Try(format, [.. round, knot], (mesh, inside, random, i) =>
    {
        var origin = inside(random);
        var d = i % 5 == 4 ? Some.Direction(random) : (Aim(mesh, random, i) - origin).Normalized;
        return mesh.Intersect(new Ray(origin, d)) is not null;
    });

    /// <summary>A ray to an inner point, through corners and edges on purpose, hits where it goes in, not only behind that point.</summary>
    [Theory]
    [MemberData(nameof(Formats))]
    public void FromOutsideEveryRayHitsWhereItGoesIn(string format) => Try(format, round, (mesh, inside, random, i) =>
    {
        var (X, target) = (Aim(mesh, random, i), inside(random));
        var origin = X + Math.Pow(10, 4 * random.NextDouble() - 2) * (X - target); // near and far
        var hit = mesh.Intersect(new Ray(origin, (X - origin).Normalized));
        return hit < (X - origin).Length + 0.5 * (target - X).Length;
    });

    [Theory]
    [MemberData(nameof(Formats))]
    public void FromOutsideEveryRayToAPointInAKnotHitsBeforeIt(string format) => Try(format, [knot], (mesh, inside, random, _) =>
    {
        var (X, target) = (Aim(mesh, random, 3), inside(random));
        var origin = X + 20 * (X - target);
        return mesh.Intersect(new Ray(origin, (target - origin).Normalized)) < (target - origin).Length;
    });

    private void Try(string format, (string Name, MeshData Data)[] solids, Func<Mesh, Func<Random, Vector3>, Random, int, bool> isHit)
    {
        var rays = 0;
        foreach (var (name, data) in solids)
        {
            var read = formats[format](data);
            foreach (var (place, placement) in placements)
            {
                var mesh = placement.Place(read, out var dropped);
                Assert.Equal(0, dropped);
                var random = new Random(9);
                for (var i = 0; i < count; i++, rays++)
                    Assert.True(isHit(mesh, Inside, random, i), $"{name}, {format}, {place}: ray {i} finds a hole");

                Vector3 Inside(Random random) => Placed(placement, name == knot.Name ? InTube(read, random) : Some.Point(random, 0.4));
            }
        }
        output.WriteLine($"{format}: {rays:N0} rays, none escapes");
    }

    /// <summary>A point of the mesh's surface, on a corner or an edge on purpose.</summary>
    private static Vector3 Aim(Mesh mesh, Random random, int i)
    {
        var (a, b, c) = mesh[random.Next(mesh.TriangleCount)];
        var (u, v) = (random.NextDouble(), random.NextDouble());
        return (i % 4) switch { 0 => a, 1 => 0.5 * (b + c), 2 => a + u * (b - a), _ => a + v * ((1 - u) * (b - a) + u * (c - a)) };
    }

    /// <summary>A point a little below the middle of a triangle, which is seen counter-clockwise from outside.</summary>
    private static Vector3 InTube(MeshData data, Random random)
    {
        var i = 3 * random.Next(data.Indices.Length / 3);
        var (a, b, c) = (data.Vertices[data.Indices[i]], data.Vertices[data.Indices[i + 1]], data.Vertices[data.Indices[i + 2]]);
        return (a + b + c) / 3 - (0.01 + 0.04 * random.NextDouble()) * ((b - a) % (c - a)).Normalized;
    }

    private static Vector3 Placed(MeshPlacement placement, Vector3 p) =>
        placement.Place(new([p, p + new Vector3(1, 0, 0), p + new Vector3(0, 1, 0)], [0, 1, 2]), out _)[0].A;
}
