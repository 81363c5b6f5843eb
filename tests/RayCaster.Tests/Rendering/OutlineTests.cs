using RayCaster.Tests.Models;

namespace RayCaster.Tests.Rendering;

/// <summary>
/// Rays aimed at edges, corners and rims, where rounding decides what is hit, the more the farther they are: what the fast renderer
/// rejects early needs a margin for that, or it loses hits that the definition has.
/// </summary>
public class OutlineTests
{
    private static readonly Triangle triangle = new(new(1, 0, 0), new(0, 1, 0.5), new(-1, -1, 0));
    private static readonly Mesh cube = Solids.Cube(), ball = Solids.Icosphere(2);

    /// <summary>Shapes of about length 1 around the origin, and points of the outline that a camera sees.</summary>
    private static readonly Dictionary<string, (Model Model, Func<Random, Vector3, Vector3> Outline)> shapes = new()
    {
        ["sphere"] = (Model.Of(new Sphere(Vector3.Zero, 1)), (random, position) =>
        {
            var towards = 1 / position.Length * position.Normalized; // the tangents' points lie around this one
            return towards + Math.Sqrt(1 - towards * towards) * (Some.Direction(random) % position).Normalized;
        }
        ),
        ["aabb"] = (Model.Of(new Aabb(new(-1, -1, -1), new(1, 1, 1))), (random, _) => OnOutline(random, cube)),
        ["circle"] = (Model.Of(new Circle(Vector3.Zero, new(0, 0, 1), 1)), (random, _) => (Some.Direction(random) % new Vector3(0, 0, 1)).Normalized),
        ["triangle"] = (Model.Of(triangle), (random, _) => OnOutline(random, triangle)),
        ["cube of triangles"] = (cube, (random, _) => OnOutline(random, cube)),
        ["ball of triangles"] = (ball, (random, _) => OnOutline(random, ball)),
    };

    public static TheoryData<string> Shapes => [.. shapes.Keys];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void IsHitByTheFastRendererAsByTheDefinition(string shape)
    {
        var (model, outline) = shapes[shape];
        model.Name = shape;
        var random = new Random(9);
        var hits = 0;
        for (var i = 0; i < 1000; i++)
        {
            var distance = Math.Pow(10, 0.5 + 9 * random.NextDouble());
            var position = distance * Some.Direction(random);
            var target = outline(random, position); // on the ray of the pixel in column 1 and row 1 of 2
            var camera = new Camera(position, target, Some.Direction(random), fovY: 1, width: 2, height: 2, zFar: 2 * distance);
            var scene = new Scene(camera, [model]);
            RendererTests.AssertEqual(scene, $"{shape} from {position} towards {target}");
            if (ScalarRenderer.Cast(scene, 1, 1).HitModel is not null) hits++;
        }
        Assert.True(hits > 100, $"only {hits} rays hit: they test little");
    }

    private static Vector3 OnOutline(Random random, Mesh mesh) => OnOutline(random, mesh[random.Next(mesh.TriangleCount)]);

    /// <summary>A corner, or a point of an edge.</summary>
    private static Vector3 OnOutline(Random random, Triangle triangle)
    {
        var share = Math.Max(0, 2 * random.NextDouble() - 1);
        return random.Next(3) switch
        {
            0 => triangle.A + share * (triangle.B - triangle.A),
            1 => triangle.B + share * (triangle.C - triangle.B),
            _ => triangle.C + share * (triangle.A - triangle.C),
        };
    }
}
