using System.Runtime.Intrinsics;

namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Each margin of the filter is needed: without it pixels of these scenes come out wrong, with it none.</summary>
public class MarginTests
{
    [Fact]
    public void WithoutTheMarginOfCornersRaysThroughEdgesGetTheWrongTriangle() =>
        AssertNeeded(OnEdges, camera => new(camera) { Margin = 0 });

    [Fact]
    public void WithoutTheNearBoundOfSureHitsTrianglesHideOthersWhereTheNearPlaneCutsThem() =>
        AssertNeeded(random => CutBy(2 + 0.03 * random.NextDouble(), 100), camera => new(camera) { MaxSureInverseDepth = float.MaxValue });

    [Fact]
    public void WithoutTheFarBoundOfSureHitsTrianglesCoverWhereTheFarPlaneCutsThem() =>
        AssertNeeded(random => CutBy(0.01, 2.02 + 0.04 * random.NextDouble()), camera => new(camera) { MinSureInverseDepth = 0 });

    [Fact]
    public void WithoutTheLeastWidthNeedlesAreTakenToLieWhereTheyDoNot() =>
        AssertNeeded(random => Needles(random, thinnest: -6, 1000), camera => new(camera) { MinWidth = 0 });

    [Fact]
    public void WithoutTheMarginOfRoundingNeedlesAreTakenToLieWhereTheyDoNot() =>
        AssertNeeded(random => Needles(random, thinnest: -3, 100), camera => new(camera) { Roundings = 0 });

    /// <summary>So flat, across the view, that what floats make of w is off by more than the corners' margin moves it.</summary>
    [Fact]
    public void WithoutTheMarginOfRoundingTheWrongOneOfTwoFlatTrianglesIsInFront() =>
        AssertNeeded(random => Sheets(random, slope: 1e-6, gap: 1e-9), camera => new(camera) { Roundings = 0 });

    /// <summary>Up is so near the view direction that the camera's axes are hardly at right angles, and rays pass beside their pixels.</summary>
    [Fact]
    public void WithoutTheMarginOfSkewRaysThroughEdgesGetTheWrongTriangle() =>
        AssertNeeded(Skewed, camera => new(camera) { Margin = new ScreenSpace(Upright(camera)).Margin });

    [Fact]
    public void WithoutTheMarginOfCornersGroupsAreMissingInTilesToWhichTheyReach() =>
        AssertNeeded(UpToATile, camera => new(camera) { Margin = 0 });

    [Fact]
    public void WithoutTheMarginOfCornersTheWrongOneOfTwoSteepTrianglesIsInFront() =>
        AssertNeeded(Steep, camera => new(camera) { Margin = 0 });

    /// <summary>A triangle is dropped where the one sample in its box is surely beside it.</summary>
    [Fact]
    public void WithoutTheMarginOfCornersTrianglesAreDroppedWhoseSampleTheyCover()
    {
        var (camera, mesh) = OnEdges(new Random(1));
        var screen = new ScreenSpace(camera);
        var corners = new MeshCorners<Packet>(screen, mesh.Vertices, mesh.Indices);
        var missing = 0;
        for (var i = 0; i < corners.Count; i++)
        {
            corners.Project([i, i, i, i, i, i, i, i], out var t);
            var (left, right) = (Lanes.Least(t.A.X, t.B.X, t.C.X), Lanes.Most(t.A.X, t.B.X, t.C.X));
            var (bottom, top) = (Lanes.Least(t.A.Y, t.B.Y, t.C.Y), Lanes.Most(t.A.Y, t.B.Y, t.C.Y));
            for (var column = MathF.Floor(left[0]); column <= MathF.Ceiling(right[0]); column++)
            {
                for (var row = MathF.Floor(bottom[0]); row <= MathF.Ceiling(top[0]); row++)
                {
                    var hit = new Mesh(mesh.Vertices, mesh.Indices[(3 * i)..(3 * i + 3)]).Intersect(camera.RayThrough((int)column, (int)row));
                    if (hit is null) continue;
                    bool Passes(float margin) => 0 != TriangleSetUp.IsOutside(
                        t, Vector256.Create(column), Vector256.Create(row), right - left + (top - bottom), Vector256.Create(margin))[0];
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
        var corners = new MeshCorners<Packet>(screen, vertices, [.. Enumerable.Range(0, vertices.Length / 3 * 3)]);
        var worst = 0.0;
        for (var i = 0; i < corners.Count; i += 8)
        {
            corners.Project([.. Enumerable.Range(i, 8).Select(triangle => Math.Min(triangle, corners.Count - 1))], out var seen);
            for (var lane = 0; lane < Math.Min(8, corners.Count - i); lane++)
            {
                var p = screen.ToCamera(vertices[3 * (i + lane)]);
                var (x, y, _) = screen.Project<Scalar>(p.X, p.Y, p.Z);
                worst = Math.Max(worst, Math.Max(Math.Abs(seen.A.X[lane] - x), Math.Abs(seen.A.Y[lane] - y)));
            }
        }
        Assert.InRange(worst, screen.Margin / 16, screen.Margin);
    }

    /// <summary>Small triangles with a side that passes a sample by less than floats can distinguish, on either side of it.</summary>
    private static (Camera Camera, MeshData Mesh) OnEdges(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero, fovY: 40, width: 1000, height: 64);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 80; i++)
        {
            var (column, row) = (random.Next(600, 990) + 1e-6 * (2 * random.NextDouble() - 1), random.Next(5, 60));
            Vector3 At(double c, double r) => camera.Position
                + 3 * (camera.PlaneWidth * (c / camera.Width - 0.5) * camera.U
                    + camera.PlaneHeight * (r / camera.Height - 0.5) * camera.V - camera.W);
            var slant = random.NextDouble();
            vertices.AddRange([At(column - 0.7 * slant, row - 0.7), At(column + 0.6 * slant, row + 0.6), At(column - 0.8, row + 0.1)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Before a wall, long and thin triangles that pass through it just behind a sample.</summary>
    /// <param name="random">Any.</param>
    /// <param name="thinnest">The power of ten of the least width, in pixels; the greatest is ten times that.</param>
    /// <param name="count">How many.</param>
    private static (Camera Camera, MeshData Mesh) Needles(Random random, double thinnest, int count)
    {
        var camera = new Camera(Vector3.Zero, new(-0.6, 0.5, 0.3), fovY: 40, width: 16, height: 16);
        var vertices = new List<Vector3> { At(camera, -20, -20, 1), At(camera, 50, -20, 1), At(camera, -20, 50, 1) };
        for (var i = 0; i < count; i++)
        {
            var (column, row, before, behind) = (random.Next(16), random.Next(16), 250 * random.NextDouble(), 250 * random.NextDouble());
            var ((up, right), width) = (Math.SinCos(2 * Math.PI * random.NextDouble()), Math.Pow(10, thinnest + random.NextDouble()));
            var (w, steepness) = (1 + Math.Pow(10, -1 - 5 * random.NextDouble()), (random.NextDouble() - 0.5) / 400);
            var (left, other) = (width * random.NextDouble(), width * random.NextDouble());
            vertices.AddRange([
                At(camera, column - before * right, row - before * up, w + steepness * before),
                At(camera, column + behind * right - left * up, row + behind * up + left * right, w - steepness * behind),
                At(camera, column + behind * right + other * up, row + behind * up - other * right, w - steepness * behind)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Four triangles that fill the picture, one closely behind the other.</summary>
    private static (Camera Camera, MeshData Mesh) Sheets(Random random, double slope, double gap)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero, fovY: 40, width: 64, height: 64);
        var vertices = new List<Vector3>();
        var (right, up, nearest) = (slope * (random.NextDouble() - 0.5), slope * (random.NextDouble() - 0.5), 1 + random.NextDouble());
        for (var i = 0; i < 4; i++)
        {
            vertices.AddRange([Corner(-80, -80), Corner(190, -80), Corner(-80, 190)]);

            Vector3 Corner(double column, double row)
            {
                (column, row) = (column + 50 * random.NextDouble(), row + 50 * random.NextDouble());
                return At(camera, column, row, nearest * (1 + right * column + up * row + gap * i));
            }
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Small triangles that end just before the first samples of a tile. The view is so narrow that rays are off by more than the padding
    /// of the groups' boxes, which are floats.</summary>
    private static (Camera Camera, MeshData Mesh) UpToATile(Random random)
    {
        var camera = new Camera(new(-5, 3, 2), Vector3.Zero, fovY: 4e-9, width: 130, height: 20);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 640; i++)
        {
            var (column, row) = (Tile.MaxSide * (1 + i / TriangleCluster.Length % 2), 2 + i % TriangleCluster.Length);
            var end = column - 5e-4 * random.NextDouble();
            vertices.AddRange([At(camera, end, row - 0.7, 1), At(camera, end, row + 0.6, 1), At(camera, end - 0.8, row + 0.1, 1)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Small triangles, some in a place, one closely behind the other, and at an angle, where floats are at their coarsest.</summary>
    private static (Camera Camera, MeshData Mesh) Steep(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero, fovY: 0.0005, width: 30_000, height: 1);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 20; i++)
        {
            var column = 16_500 + 600 * i + random.Next(600);
            var (right, up) = (random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            for (var k = 0; k < 3; k++)
            {
                vertices.AddRange([Corner(-1, -1), Corner(1, -0.8), Corner(0, 1)]);

                Vector3 Corner(double x, double y)
                {
                    (x, y) = (x + 0.3 * random.NextDouble(), y + 0.3 * random.NextDouble());
                    return At(camera, column + x, y, 3 + right * x + up * y + 1e-5 * k);
                }
            }
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Small triangles to the left and right of rays that pass through one of their sides.</summary>
    private static (Camera Camera, MeshData Mesh) Skewed(Random random)
    {
        var position = new Vector3(-5, 0.3, 0.4);
        Camera camera;
        do
        {
            var up = position.Normalized + 1e-9 * new Vector3(random.NextDouble(), random.NextDouble(), random.NextDouble());
            camera = new(position, Vector3.Zero, up: up, fovY: 0.01, width: 32, height: 32);
        }
        while (camera.Skew is < 5e-9 or > 1e-8);
        var vertices = new List<Vector3>();
        for (var i = 0; i < 100; i++)
        {
            var (column, row) = (random.Next(32) + 1e-6 * (2 * random.NextDouble() - 1), random.Next(2, 30));
            var (slant, side) = (random.NextDouble(), 1.6 * random.Next(2) - 0.8);
            vertices.AddRange([Ahead(column - 0.7 * slant, row - 0.7), Ahead(column + 0.6 * slant, row + 0.6), Ahead(column + side, row + 0.1)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));

        Vector3 Ahead(double column, double row)
        {
            var d = camera.Direction<Scalar>(column, row);
            return position + 3 * new Vector3(d.X, d.Y, d.Z);
        }
    }

    /// <summary>The same camera with its axes at right angles.</summary>
    private static Camera Upright(Camera camera) =>
        camera.With(up: new(0, 0, 1));

    /// <summary>The point of a w that is seen at a place of the picture.</summary>
    private static Vector3 At(Camera camera, double column, double row, double w) => camera.Position + 3 / w
        * (camera.PlaneWidth * (column / camera.Width - 0.5) * camera.U + camera.PlaneHeight * (row / camera.Height - 0.5) * camera.V - camera.W);

    /// <summary>A ball that a clip plane cuts where it fills the picture.</summary>
    private static (Camera Camera, MeshData Mesh) CutBy(double zNear, double zFar) => (
        new(new(3, 0.013, 0.017), Vector3.Zero, fovY: 12, width: 64, height: 64, zNear: zNear, zFar: zFar),
        MeshGenerator.Icosphere(2));

    private static void AssertNeeded(Func<Random, (Camera Camera, MeshData Mesh)> make, Func<Camera, ScreenSpace> without)
    {
        var wrong = 0;
        for (var seed = 0; seed < 3 && wrong == 0; seed++)
        {
            var (camera, mesh) = make(new Random(seed));
            var scene = new Scene(camera, [new Mesh(mesh.Vertices, mesh.Indices)]);
            var definition = new double[camera.Height, camera.Width];
            for (var row = 0; row < camera.Height; row++)
                for (var column = 0; column < camera.Width; column++)
                    definition[row, column] = ScalarRenderer.Cast(scene, column, row).HitParameter;
            Assert.Equal(0, WrongPixels(scene, definition, new(camera)));
            wrong += WrongPixels(scene, definition, without(camera));
        }
        Assert.NotEqual(0, wrong);
    }

    private static int WrongPixels(Scene scene, double[,] definition, ScreenSpace screen)
    {
        var camera = scene.Camera;
        object? shared = null;
        var view = new MeshView<Packet>((Mesh)scene.Models[0], screen, default).ForThread(ref shared);
        var (span, wrong) = (new RayStream(camera), 0);
        for (var column = 0; column < camera.Width; column += Tile.MaxSide)
        {
            for (var row = 0; row < camera.Height; row += Tile.MaxSide)
            {
                var tile = new PixelRect(column, row, Math.Min(Tile.MaxSide, camera.Width - column), Math.Min(Tile.MaxSide, camera.Height - row));
                var range = view.Enter(tile, new(0, double.PositiveInfinity));
                span.Enter<Packet>(column, tile.Width);
                for (var r = row; r < tile.EndRow; r++)
                {
                    span.Aim<Packet>(r);
                    view.Intersect(span, 0);
                    for (var i = 0; i < tile.Width; i++)
                    {
                        var t = definition[r, column + i];
                        if (!span.T[i].Equals(t) || t < range.NearestT || t > range.FarthestT) wrong++;
                    }
                }
            }
        }
        return wrong;
    }
}
