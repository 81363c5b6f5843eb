using System.Runtime.Intrinsics;
using RayCaster.Tests.MeshFiles;

namespace RayCaster.Tests.Rendering.Meshes;

/// <summary>Each margin of the filter is needed: without it pixels of these scenes come out wrong, with it none.</summary>
public class MarginTests
{
    [Fact]
    public void WithoutTheMarginOfCornersRaysThroughEdgesGetTheWrongTriangle() =>
        AssertNeeded(OnEdges, camera => new(camera) { Margin = 0 });

    [Fact]
    public void WithoutTheNearBoundOfSureHitsTrianglesHideOthersWhereTheNearPlaneCutsThem() =>
        AssertNeeded(random => CutBy(2 + 0.03 * random.NextDouble(), 100), camera => new(camera) { MostSureW = float.MaxValue });

    [Fact]
    public void WithoutTheFarBoundOfSureHitsTrianglesCoverWhereTheFarPlaneCutsThem() =>
        AssertNeeded(random => CutBy(0.01, 2.02 + 0.04 * random.NextDouble()), camera => new(camera) { LeastSureW = 0 });

    /// <summary>A triangle is dropped where the one sample in its box is surely beside it.</summary>
    [Fact]
    public void WithoutTheMarginOfCornersTrianglesAreDroppedWhoseSampleTheyCover()
    {
        var (camera, mesh) = OnEdges(new Random(1));
        var screen = new ScreenSpace(camera);
        var corners = new MeshCorners(screen, mesh.Vertices, mesh.Indices);
        var missing = 0;
        for (var i = 0; i < corners.Count; i++)
        {
            corners.See([i, i, i, i, i, i, i, i], out var t);
            var (left, right) = (Lanes.Least(t.A.X, t.B.X, t.C.X), Lanes.Most(t.A.X, t.B.X, t.C.X));
            var (bottom, top) = (Lanes.Least(t.A.Y, t.B.Y, t.C.Y), Lanes.Most(t.A.Y, t.B.Y, t.C.Y));
            for (var column = MathF.Floor(left[0]); column <= MathF.Ceiling(right[0]); column++)
            {
                for (var row = MathF.Floor(bottom[0]); row <= MathF.Ceiling(top[0]); row++)
                {
                    var hit = new Mesh(mesh.Vertices, mesh.Indices[(3 * i)..(3 * i + 3)]).Intersect(camera.CastRay((int)column, (int)row));
                    if (hit is null) continue;
                    bool Passes(float margin) => 0 != TriangleSetUp.Pass(
                        t, Vector256.Create(column), Vector256.Create(row), right - left + (top - bottom), Vector256.Create(margin), out _)[0];
                    Assert.False(Passes(screen.Margin), $"triangle {i} at {column}, {row}");
                    if (Passes(0)) missing++;
                }
            }
        }
        Assert.NotEqual(0, missing);
    }

    [Fact]
    public void ProjectedCornersAreOffByALargePartOfTheirMargin()
    {
        var camera = new Camera(new(3, 1, 2), Vector3.Zero, width: 1920, height: 1080);
        var screen = new ScreenSpace(camera);
        var random = new Random(1);
        var vertices = new Vector3[100_000];
        for (var i = 0; i < vertices.Length; i++) vertices[i] = new(random.NextDouble(), random.NextDouble(), random.NextDouble());
        var corners = new MeshCorners(screen, vertices, [.. Enumerable.Range(0, vertices.Length / 3 * 3)]);
        var worst = 0.0;
        for (var i = 0; i < corners.Count; i += 8)
        {
            corners.See([.. Enumerable.Range(i, 8).Select(triangle => Math.Min(triangle, corners.Count - 1))], out var seen);
            for (var lane = 0; lane < Math.Min(8, corners.Count - i); lane++)
            {
                var p = screen.See(vertices[3 * (i + lane)]);
                var (x, y, _) = screen.Project<Scalar>(p.X, p.Y, p.Z);
                worst = Math.Max(worst, Math.Max(Math.Abs(seen.A.X[lane] - x), Math.Abs(seen.A.Y[lane] - y)));
            }
        }
        Assert.InRange(worst, screen.Margin / 16, screen.Margin);
    }

    /// <summary>Small triangles with a side that passes a sample by less than what floats tell apart, on either side of it.</summary>
    private static (Camera Camera, MeshData Mesh) OnEdges(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero, fovY: 40, width: 1000, height: 64);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 200; i++)
        {
            var (column, row) = (random.Next(600, 990) + 1e-6 * (2 * random.NextDouble() - 1), random.Next(5, 60));
            Vector3 At(double c, double r) => camera.Position
                + 3 * (camera.PlaneWidth * (c / camera.Width - 0.5) * camera.U + camera.PlaneHeight * (r / camera.Height - 0.5) * camera.V - camera.W);
            var slant = random.NextDouble();
            vertices.AddRange([At(column - 0.7 * slant, row - 0.7), At(column + 0.6 * slant, row + 0.6), At(column - 0.8, row + 0.1)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>A ball that a clip plane cuts where it fills the picture.</summary>
    private static (Camera Camera, MeshData Mesh) CutBy(double zNear, double zFar) => (
        new(new(3, 0.013, 0.017), Vector3.Zero, fovY: 12, width: 64, height: 64, zNear: zNear, zFar: zFar),
        MeshGenerator.Icosphere(2));

    private static void AssertNeeded(Func<Random, (Camera Camera, MeshData Mesh)> make, Func<Camera, ScreenSpace> without)
    {
        var wrong = 0;
        for (var seed = 0; seed < 2; seed++)
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
        var (span, wrong) = (new RaySpan(camera), 0);
        for (var column = 0; column < camera.Width; column += Tile.MaxSide)
        {
            for (var row = 0; row < camera.Height; row += Tile.MaxSide)
            {
                var tile = new Tile(column, row, Math.Min(Tile.MaxSide, camera.Width - column), Math.Min(Tile.MaxSide, camera.Height - row));
                var range = view.Enter(tile, HitRange.Unknown);
                span.Enter<Packet>(column, tile.Width);
                for (var r = row; r < tile.EndRow; r++)
                {
                    span.Aim<Packet>(r);
                    view.Meet(span, 0);
                    for (var i = 0; i < tile.Width; i++)
                    {
                        var t = ScalarRenderer.Cast(scene, column + i, r).HitParameter;
                        if (!span.T[i].Equals(t) || t < range.Least || t > range.Cover) wrong++;
                    }
                }
            }
        }
        return wrong;
    }
}
