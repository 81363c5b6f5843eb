namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Meshes with rays so near to their edges, corners and clip planes that a filter without its margins gets pixels wrong.</summary>
public class MarginTests
{
    private static readonly Dictionary<string, Func<Random, (Camera Camera, MeshData Mesh)>> scenes = new()
    {
        ["rays through edges"] = OnEdges,
        ["cut by the near plane"] = random => CutBy(2 + 0.03 * random.NextDouble(), 100),
        ["cut by the far plane"] = random => CutBy(0.01, 2.02 + 0.04 * random.NextDouble()),
        ["thinnest needles"] = random => Needles(random, thinnest: -6, 1000),
        ["thin needles"] = random => Needles(random, thinnest: -3, 100),
        ["flat sheets"] = random => Sheets(random, slope: 1e-6, gap: 1e-9), // across the view; what floats make of w does not tell them apart
        ["hardly upright"] = Skewed, // the camera's axes are hardly at right angles, and rays pass beside their pixels
        ["up to a tile"] = UpToATile,
        ["steep"] = Steep,
    };

    public static TheoryData<string> Scenes => [.. scenes.Keys];

    [Theory]
    [MemberData(nameof(Scenes))]
    public void TheseComeOutToTheBit(string name)
    {
        for (var seed = 0; seed < 3; seed++)
        {
            var (camera, mesh) = scenes[name](new Random(seed));
            RendererTests.AssertEqual(new(camera, [new Mesh(mesh.Vertices, mesh.Indices)]), $"{name}, seed {seed}");
        }
    }

    /// <summary>Small triangles with a side that passes a sample by less than floats can distinguish, on either side of it.</summary>
    private static (Camera Camera, MeshData Mesh) OnEdges(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero) { FovY = 40, Width = 1000, Height = 64 };
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
        var camera = new Camera(Vector3.Zero, new(-0.6, 0.5, 0.3)) { FovY = 40, Width = 16, Height = 16 };
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
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero) { FovY = 40, Width = 64, Height = 64 };
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
        var camera = new Camera(new(-5, 3, 2), Vector3.Zero) { FovY = 4e-9, Width = 130, Height = 20 };
        var vertices = new List<Vector3>();
        for (var i = 0; i < 640; i++)
        {
            var (column, row) = (Tile.MaxSide * (1 + i / TriangleBoxes.ClusterLength % 2), 2 + i % TriangleBoxes.ClusterLength);
            var end = column - 5e-4 * random.NextDouble();
            vertices.AddRange([At(camera, end, row - 0.7, 1), At(camera, end, row + 0.6, 1), At(camera, end - 0.8, row + 0.1, 1)]);
        }
        return (camera, new([.. vertices], [.. Enumerable.Range(0, vertices.Count)]));
    }

    /// <summary>Small triangles, some in a place, one closely behind the other, and at an angle, where floats are at their coarsest.</summary>
    private static (Camera Camera, MeshData Mesh) Steep(Random random)
    {
        var camera = new Camera(new(-5, 0, 0), Vector3.Zero) { FovY = 0.0005, Width = 30_000, Height = 1 };
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
            camera = new(position, Vector3.Zero) { Up = up, FovY = 0.01, Width = 32, Height = 32 };
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

    /// <summary>The point of a w that is seen at a place of the picture.</summary>
    private static Vector3 At(Camera camera, double column, double row, double w) => camera.Position + 3 / w
        * (camera.PlaneWidth * (column / camera.Width - 0.5) * camera.U + camera.PlaneHeight * (row / camera.Height - 0.5) * camera.V - camera.W);

    /// <summary>A ball that a clip plane cuts where it fills the picture.</summary>
    private static (Camera Camera, MeshData Mesh) CutBy(double zNear, double zFar) => (
        new(new(3, 0.013, 0.017), Vector3.Zero) { FovY = 12, Width = 64, Height = 64, ZNear = zNear, ZFar = zFar },
        MeshGenerator.Icosphere(2));
}
