
namespace RayCaster.Tests.Shapes;

/// <summary>A closed mesh has no hole, wherever a ray is aimed.</summary>
public class WatertightTests(ITestOutputHelper output)
{
    private static readonly (string Name, Mesh Mesh)[] solids =
        [("cube", Solids.Cube()), ("icosphere 80", Solids.Icosphere(1))];

    /// <summary>
    /// From inside a closed mesh every ray hits it. The textbook's formula loses rays that are aimed at corners: rounding makes the triangles
    /// that share a corner disagree about where the ray passes. A test that passed with this formula, too, would prove nothing.
    /// </summary>
    [Fact]
    public void FromInsideEveryRayHitsAlthoughTheTextbookLosesRaysAtCorners()
    {
        var random = new Random(5);
        foreach (var (name, mesh) in solids)
        {
            var (ours, textbooks) = (0, 0); // lost rays
            for (var i = 0; i < 4000; i++)
            {
                var origin = Some.Point(random, 0.5);
                var (a, b, c) = mesh[random.Next(mesh.TriangleCount)];
                var onEdge = random.NextDouble();
                var aim = (i % 4) switch
                {
                    0 => a,
                    1 => 0.5 * (a + b),
                    2 => a + onEdge * (c - a),
                    _ => Some.Point(random, 1),
                };
                var d = (aim - origin).Normalized;
                if (mesh.Intersect(new Ray(origin, d)) is null) ours++;
                if (!Enumerable.Range(0, mesh.TriangleCount).Any(triangle => MollerTrumbore(mesh[triangle], origin, d))) textbooks++;
            }
            output.WriteLine($"{name}: ours loses {ours} rays, Möller–Trumbore {textbooks}");
            Assert.Equal(0, ours);
            Assert.True(textbooks > 0, "Möller–Trumbore should lose some of these rays");
        }
    }

    /// <summary>Möller, Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, edges included.</summary>
    private static bool MollerTrumbore(Triangle triangle, Vector3 origin, Vector3 d)
    {
        var (e1, e2, s) = (triangle.B - triangle.A, triangle.C - triangle.A, origin - triangle.A);
        var determinant = d % e2 * e1;
        var (u, v, t) = (d % e2 * s / determinant, s % e1 * d / determinant, s % e1 * e2 / determinant);
        return u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    }

    /// <summary>The faces' diagonals lie on the picture's diagonals, so that hundreds of rays run exactly through edges.</summary>
    [Theory]
    [InlineData(5, 0, 0)]
    [InlineData(-5, 0, 0)]
    [InlineData(0, 5, 0)]
    [InlineData(0, -5, 0)]
    [InlineData(0, 0, 5)]
    [InlineData(0, 0, -5)]
    [InlineData(4, 4, 0)]   // an edge on the middle column
    [InlineData(3, 3, 3)]   // a corner in the middle
    public void ACubeOfTrianglesCoversWhatTheBoxCovers(double x, double y, double z)
    {
        var up = x == 0 && y == 0 ? new Vector3(0, 1, 0) : new(0, 0, 1);
        var camera = new Camera(new(x, y, z), default) { Up = up, FovY = 60, Width = 128, Height = 128 };
        var mesh = Covered(Solids.Cube());
        var (smaller, larger) = (Covered(Box(1 - 1e-12)), Covered(Box(1 + 1e-12)));
        Assert.InRange(mesh.Count(covered => covered), 1000, 16_000);
        var (holes, tooMuch) = (Pixels(camera).Where((_, i) => smaller[i] && !mesh[i]), Pixels(camera).Where((_, i) => mesh[i] && !larger[i]));
        Assert.Empty(holes);
        Assert.Empty(tooMuch);

        bool[] Covered(Model model)
        {
            var scene = new Scene(camera, [model]);
            return [.. Pixels(camera).Select(pixel => IsHit(scene, pixel))];
        }
    }

    [Fact]
    public void AnIcosphereSeenFromItsMiddleFillsThePictureInEveryDirection()
    {
        var mesh = Solids.Icosphere(2);
        Vector3[] targets = [new(1, 0, 0), new(-1, 0, 0), new(0, 1, 0), new(0, -1, 0), new(1, 1, 1), mesh[0].A, mesh[40].B];
        foreach (var target in targets)
        {
            var scene = new Scene(new(default, target) { Up = new(0.1, 0.2, 1), FovY = 90, Width = 24, Height = 24 }, [mesh]);
            Assert.All(Pixels(scene.Camera), pixel => Assert.True(IsHit(scene, pixel), $"a hole at {pixel} towards {target}"));
        }
    }

    private static bool IsHit(Scene scene, (int Column, int Row) pixel) =>
        ScalarRenderer.Cast(scene, pixel.Column, pixel.Row).Model >= 0;

    private static Model Box(double size) => Model.Of(new Aabb(-size * new Vector3(1, 1, 1), size * new Vector3(1, 1, 1)));

    private static IEnumerable<(int Column, int Row)> Pixels(Camera camera) =>
        from row in Enumerable.Range(0, camera.Height) from column in Enumerable.Range(0, camera.Width) select (column, row);
}
