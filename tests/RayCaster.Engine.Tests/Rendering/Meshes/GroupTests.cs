namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>Tests of several consecutive triangles at once give the same results as tests of each triangle.</summary>
public class GroupTests
{
    private static readonly Camera camera = new(new(5, 0.4, 0.3), Vector3.Zero, width: 640, height: 480);

    [Fact]
    public void AGroupIsInTheTileOfItsTriangles()
    {
        const int length = TriangleCluster.Length;
        var (vertices, indices) = Specks(length);
        var (screen, tile) = (new ScreenSpace(camera), new PixelRect(320, 192, 64, 64));
        var corners = new MeshCorners<Packet>(screen, vertices, indices);
        var inGroups = new ScreenTriangles<Packet>(screen, corners, null, new TriangleBoxes(vertices, indices, 1), null, 1);
        var oneByOne = new ScreenTriangles<Packet>(screen, corners, null, null, null, 1);
        Assert.Equal(Enumerable.Range(0, length), oneByOne.Of(tile).ToArray().Select(item => item.Run.First));
        Assert.Equal([(0, length)], inGroups.Of(tile).ToArray().Select(item => (item.Run.First, item.Run.Count)));
    }

    /// <summary>The formula finds hits of a triangle seen edge-on only between its corners along the axis that the ray follows most.</summary>
    [Fact]
    public void AGroupHasTheGreatestInverseDepthOfItsTriangles()
    {
        var (vertices, indices) = Specks(TriangleCluster.Length);
        var (screen, tile) = (new ScreenSpace(camera), new PixelRect(320, 192, 64, 64));
        var corners = new MeshCorners<Packet>(screen, vertices, indices);
        var groups = new ScreenTriangles<Packet>(screen, corners, null, new TriangleBoxes(vertices, indices, 1), null, 1);
        var most = vertices.Max(p => screen.Unit / screen.ToCamera(p).Z);
        Assert.InRange(groups.Of(tile)[0].MaxInverseDepth, most, 1.01 * most);
    }

    /// <summary>Of triangles in a plane with the eye, the formula's areas are all rounding, and so are its hits between their corners.</summary>
    [Fact]
    public void NoHitInAGroupSeenEdgeOnHasAGreaterInverseDepth()
    {
        var (random, screen, hits) = (new Random(20261123), new ScreenSpace(camera), 0);
        for (var round = 0; round < 300; round++)
        {
            var rays = Enumerable.Range(0, 2).Select(_ => camera.RayThrough(random.Next(320, 384), random.Next(192, 256))).ToArray();
            Vector3 Point() => camera.Position + (3 + random.NextDouble()) * rays[random.Next(2)].Direction;
            var mesh = new Mesh([.. Enumerable.Range(0, 48).Select(_ => Point())], [.. Enumerable.Range(0, 48)]);
            var corners = new MeshCorners<Packet>(screen, mesh.Vertices, mesh.Indices);
            var groups = new ScreenTriangles<Packet>(screen, corners, null, new TriangleBoxes(mesh.Vertices, mesh.Indices, 1), null, 1);
            if (groups.Of(new(320, 192, 64, 64)).ToArray() is not [var group]) continue; // so near that they are sorted one by one
            foreach (var ray in rays)
            {
                if (mesh.Intersect(ray) is not { } t) continue;
                hits++;
                Assert.InRange(screen.Unit / (t * -(ray.Direction * camera.W)), 0, group.MaxInverseDepth);
            }
        }
        Assert.InRange(hits, 100, 600);
    }

    [Theory]
    [InlineData(715_000_000, 1)]
    [InlineData(16, 16)]
    public void ARunKeepsItsTriangles(int first, int count)
    {
        var run = new TriangleRun(first, count);
        Assert.Equal((first, count), (run.First, run.Count));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(15)]
    [InlineData(16)]
    [InlineData(19)]
    public void TheBoxesOfGroupsReachToEachOfTheirCorners(int count)
    {
        var (vertices, indices) = Specks(count);
        AssertBoxes(vertices, indices);
    }

    /// <summary>After the last vertex the array has no number that could be read with it.</summary>
    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    public void TheBoxOfAGroupWithTheLastVertexButFewReachesToItsCorners(int spare)
    {
        var (vertices, indices) = Specks(16);
        AssertBoxes([.. vertices, .. new Vector3[spare]], indices);
    }

    /// <summary>Boxes are floats, but the scene may be of any size and at any place.</summary>
    [Theory]
    [InlineData(1e-30, 0)]
    [InlineData(1e40, 0)]
    [InlineData(1, 1e6)]
    public void TheBoxesOfGroupsReachToTheirCornersAtAnyScale(double scale, double offset)
    {
        var (vertices, indices) = Specks(40);
        AssertBoxes([.. vertices.Select(p => new Vector3(scale * p.X + offset, scale * p.Y - offset, scale * p.Z))], indices);
    }

    [Fact]
    public void ACornerThatIsNoNumberLeavesTheBoxOfTheOthers()
    {
        Vector3[] vertices = [new(1, 2, 3), new(double.NaN, double.NaN, double.NaN), new(4, 0, 5)];
        var (low, high) = BoxOf(new(vertices, [0, 2, 1], 1), 0);
        AssertAround(low, high, [vertices[0], vertices[2]]);
    }

    private static void AssertBoxes(Vector3[] vertices, int[] indices)
    {
        var boxes = new TriangleBoxes(vertices, indices, 1);
        Assert.Equal((indices.Length / 3 + TriangleCluster.Length - 1) / TriangleCluster.Length, boxes.Count);
        for (var cluster = 0; cluster < boxes.Count; cluster++)
        {
            var (first, end) = boxes.TrianglesOf(cluster);
            var (low, high) = BoxOf(boxes, cluster);
            AssertAround(low, high, [.. indices[(3 * first)..(3 * end)].Select(i => vertices[i])]);
        }
    }

    /// <summary>A box holds its corners and is wider than they are by less than a millionth of its size and of the mesh's.</summary>
    private static void AssertAround(Vector3 low, Vector3 high, Vector3[] corners)
    {
        var size = Math.Max(high.X - low.X, Math.Max(high.Y - low.Y, high.Z - low.Z));
        foreach (var of in new Func<Vector3, double>[] { p => p.X, p => p.Y, p => p.Z })
        {
            Assert.InRange(corners.Min(of) - of(low), 0, 1e-5 * size);
            Assert.InRange(of(high) - corners.Max(of), 0, 1e-5 * size);
        }
    }

    private static (Vector3 Low, Vector3 High) BoxOf(TriangleBoxes boxes, int cluster)
    {
        return (At(boxes.Lows<Packet>(cluster)), At(boxes.Highs<Packet>(cluster)));
        Vector3 At(Vector3<Packet> p) => boxes.Middle + boxes.Unit * new Vector3(p.X.Lanes[0], p.Y.Lanes[0], p.Z.Lanes[0]);
    }

    [Theory]
    [InlineData(0, -1)]
    [InlineData(0, int.MinValue)]
    [InlineData(47, 48)]
    [InlineData(49, 54)] // of the last two triangles, which are less than can be checked at once
    [InlineData(53, int.MaxValue)]
    [InlineData(0, 0)] // of no vertices
    public void ACornerThatIsNotThereIsFoundBeforeItIsRead(int place, int index)
    {
        var (vertices, indices) = Specks(18);
        indices[place] = index;
        if (index == 48) vertices = vertices[..48];
        if (index == 0) vertices = [];
        var scene = new Scene(camera, [new Mesh(vertices, indices)]);
        Assert.Throws<IndexOutOfRangeException>(() => new Renderer(scene, 1).CastHits());
    }

    /// <summary>Small triangles about the origin.</summary>
    private static (Vector3[] Vertices, int[] Indices) Specks(int count)
    {
        var random = new Random(count);
        var vertices = new Vector3[3 * count];
        for (var i = 0; i < count; i++)
        {
            Vector3 At(double y, double z) => new(0.01 * random.NextDouble(), 0.05 + 0.01 * i % 0.04 + y, 0.02 + z);
            (vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]) = (At(0, 0), At(0.02, 0), At(0, 0.02));
        }
        return (vertices, [.. Enumerable.Range(0, 3 * count)]);
    }
}
