using RayCaster.Tests.MeshFiles;

namespace RayCaster.Tests.Rendering.Meshes;

/// <summary>Each margin of the filter is needed: without it pixels of these scenes come out wrong, with it none.</summary>
public class MarginTests
{
    [Fact]
    public void WithoutTheMarginOfCornersRaysThroughEdgesGetTheWrongTriangle() =>
        AssertNeeded(OnEdges, camera => new(camera) { Margin = 0 });

    [Fact]
    public void WithoutTheLeastWidthTrianglesSeenEdgeOnHideWhatIsInFrontOfThem() =>
        AssertNeeded(EdgeOn, camera => new(camera) { LeastWidth = 0 });

    [Fact]
    public void WithoutTheNearBoundOfSureHitsTrianglesHideOthersWhereTheNearPlaneCutsThem() =>
        AssertNeeded(Cut, camera => new(camera) { MostSureW = float.MaxValue });

    [Fact]
    public void WithoutTheFarBoundOfSureHitsTrianglesCoverWhereTheFarPlaneCutsThem() =>
        AssertNeeded(Cut, camera => new(camera) { LeastSureW = 0 });

    [Fact]
    public void ProjectedCornersAreOffByALargePartOfTheirMargin()
    {
        var camera = new Camera(new(3, 1, 2), Vector3.Zero, width: 1920, height: 1080);
        var screen = new ScreenSpace(camera);
        var random = new Random(1);
        var vertices = new Vector3[100_000];
        for (var i = 0; i < vertices.Length; i++) vertices[i] = new(random.NextDouble(), random.NextDouble(), random.NextDouble());
        var points = screen.Project(vertices, threads: 2);
        var worst = 0.0;
        for (var i = 0; i < vertices.Length; i++)
        {
            var p = screen.See(vertices[i]);
            var (x, y, _, _) = screen.Project<Scalar>(p.X, p.Y, p.Z);
            worst = Math.Max(worst, Math.Max(Math.Abs(points[i][0] - x), Math.Abs(points[i][1] - y)));
        }
        Assert.InRange(worst, screen.Margin / 16, screen.Margin);
    }

    /// <summary>A lattice of triangles whose edges lie on rays, to the last bits.</summary>
    private static (Camera Camera, MeshData Mesh) OnEdges(Random random)
    {
        var mesh = MeshGenerator.Cube(1);
        return (new(new(5, 0.1 * random.Next(-3, 4), 0.1 * random.Next(-3, 4)), new(0, 0, 0), fovY: 30, width: 1000, height: 64), mesh);
    }

    /// <summary>Large triangles in planes that nearly hold the eye, before and behind a wall.</summary>
    private static (Camera Camera, MeshData Mesh) EdgeOn(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero, fovY: 40, width: 64, height: 64);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 200; i++)
        {
            var (a, b) = (0.01 * random.Next(-100, 100), 0.01 * random.Next(-100, 100));
            Vector3 At(double x, double s) => camera.Position + (x + 5) * new Vector3(1, s * a, s * b);
            vertices.AddRange([At(random.NextDouble(), 0.3), At(random.NextDouble(), 0.1), At(random.NextDouble(), 0.3 + 1e-9 * random.NextDouble())]);
            vertices[^1] += 1e-13 * random.NextDouble() * new Vector3(0, 1, 1);
        }
        vertices.AddRange([new(0.5, -9, -9), new(0.5, 9, -9), new(0.5, 0, 9)]);
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>A ball that both clip planes cut.</summary>
    private static (Camera Camera, MeshData Mesh) Cut(Random random) =>
        (new(new(3, 0, 0), Vector3.Zero, width: 64, height: 64, zNear: 2.3 + 0.2 * random.NextDouble(), zFar: 3 + 0.5 * random.NextDouble()), MeshGenerator.Icosphere(1));

    private static void AssertNeeded(Func<Random, (Camera Camera, MeshData Mesh)> make, Func<Camera, ScreenSpace> without)
    {
        var wrong = 0;
        for (var seed = 0; seed < 20; seed++)
        {
            var (camera, mesh) = make(new Random(seed));
            Assert.Equal(0, WrongPixels(camera, mesh, new(camera)));
            wrong += WrongPixels(camera, mesh, without(camera));
        }
        Assert.NotEqual(0, wrong);
    }

    private static int WrongPixels(Camera camera, MeshData mesh, ScreenSpace screen)
    {
        var scene = new Scene(camera, [new Mesh(mesh.Vertices, mesh.Indices)]);
        var view = new MeshView(mesh.Vertices, mesh.Indices, screen).ForThread();
        var (rays, span, wrong) = (new TileRays(camera), new RaySpan(camera), 0);
        for (var column = 0; column < camera.Width; column += Tile.MaxSide)
        {
            for (var row = 0; row < camera.Height; row += Tile.MaxSide)
            {
                var tile = new Tile(column, row, Math.Min(Tile.MaxSide, camera.Width - column), Math.Min(Tile.MaxSide, camera.Height - row));
                rays.Aim(tile);
                view.Enter(rays);
                span.Enter<Packet>(column, tile.Width);
                for (var r = row; r < tile.EndRow; r++)
                {
                    span.Aim<Packet>(r);
                    view.Meet(span, 0);
                    for (var i = 0; i < tile.Width; i++)
                        if (!span.T[i].Equals(ScalarRenderer.Cast(scene, column + i, r).HitParameter)) wrong++;
                }
            }
        }
        return wrong;
    }
}
