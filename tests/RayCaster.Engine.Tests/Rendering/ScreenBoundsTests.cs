namespace RayCaster.Engine.Tests.Rendering;

/// <summary>
/// Rays aimed at edges, corners and rims, where rounding decides what is hit, the more the farther they are: what the fast renderer
/// rejects early needs a margin for that, or it loses hits that the definition has.
/// </summary>
public class ScreenBoundsTests
{
    private static readonly Vector3 up = new(0, 0, 1);
    private static readonly Triangle triangle = new(new(1, 0, 0), new(0, 1, 0.5), new(-1, -1, 0));
    private static readonly Mesh cube = Solids.Cube(), ball = Solids.Icosphere(2);

    /// <summary>Shapes of about length 1 around the origin, and points of their outlines for a camera's rays of a direction.</summary>
    private static readonly Dictionary<string, (Model Model, Func<Random, Camera, Vector3, Vector3> Outline)> shapes = new()
    {
        ["sphere"] = (Model.Of(new Sphere(Vector3.Zero, 1)), (random, _, d) => (Some.Direction(random) % d).Normalized),
        ["sphere at its sides"] = (Model.Of(new Sphere(Vector3.Zero, 1)), (random, camera, d) =>
            (random.Next(2) * 2 - 1) * (d % (random.Next(2) == 0 ? camera.U : camera.V)).Normalized),
        ["aabb"] = (Model.Of(new Aabb(new(-1, -1, -1), new(1, 1, 1))), (random, _, _) => OnOutline(random, cube)),
        ["circle"] = (Model.Of(new Circle(Vector3.Zero, up, 1)), (random, _, _) => (Some.Direction(random) % up).Normalized),
        ["triangle"] = (Model.Of(triangle), (random, _, _) => OnOutline(random, triangle)),
        ["cube of triangles"] = (cube, (random, _, _) => OnOutline(random, cube)),
        ["ball of triangles"] = (ball, (random, _, _) => OnOutline(random, ball)),
    };

    public static TheoryData<string> Shapes => [.. shapes.Keys];

    [Theory]
    [MemberData(nameof(Shapes))]
    public void IsHitByTheFastRendererAsByTheDefinition(string shape) => AssertIsHit(shape, companions: 0);

    /// <summary>With so many models behind the camera that they are drawn as a batch.</summary>
    [Theory]
    [InlineData("sphere")]
    [InlineData("sphere at its sides")] // where the rectangle in which it is looked for ends
    [InlineData("aabb")]
    [InlineData("circle")]
    [InlineData("triangle")]
    public void IsHitInACrowd(string shape) => AssertIsHit(shape, companions: 100);

    /// <summary>A sample; .ci/run sets RAYCASTER_SCENES. Fewer would say nothing about the share of those that hit.</summary>
    private static int Rays =>
        int.TryParse(Environment.GetEnvironmentVariable("RAYCASTER_SCENES"), out var scenes) ? Math.Max(400, 5 * scenes) : 400;

    private static void AssertIsHit(string shape, int companions)
    {
        var (model, outline) = shapes[shape];
        var random = Some.Chance(9);
        var hits = 0;
        for (var i = 0; i < Rays; i++)
        {
            var distance = Math.Pow(10, 0.5 + 9 * random.NextDouble());
            var fovY = 2 * Math.Atan(Math.Pow(10, 2 * random.NextDouble() - 0.5) / distance) * 180 / Math.PI;
            var (width, height) = (random.Next(1, 200), random.Next(1, 200));
            var (column, row) = (random.Next(width), random.Next(height));
            var (look, tilt) = (Some.Direction(random), Some.Direction(random));

            // The camera is put where the ray of this pixel passes through a point of the outline.
            var turned = new Camera(Vector3.Zero, look) { Up = tilt, FovY = fovY, Width = width, Height = height };
            var d = turned.RayThrough(column, row).Direction;
            var position = outline(random, turned, d) - distance * d;
            var camera = new Camera(position, position + distance * look)
            {
                Up = tilt,
                FovY = fovY,
                Width = width,
                Height = height,
                ZFar = 2 * distance,
            };
            var behind = Model.Of(new Sphere(position - distance * look, 1));
            var scene = new Scene(camera, [.. Enumerable.Repeat(behind, companions), model]);

            var fast = new Renderer(scene, threads: 1).CastHits();
            var exact = ScalarRenderer.Cast(scene, column, row);
            var t = fast.T[(height - 1 - row) * width + column];
            Assert.True(t.Equals(exact.T), $"{shape} (RAYCASTER_SEED={Campaign.Seed}) from {position}, look {look}, up {tilt}, "
                + $"fovY {fovY:R}, {width} x {height}, "
                + $"column {column}, row {row}: the definition's t is {exact.T:R}, the renderer's {t:R}");
            if (exact.Model >= 0) hits++;
        }
        Assert.InRange(hits, 0.1 * Rays, 0.985 * Rays);
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
