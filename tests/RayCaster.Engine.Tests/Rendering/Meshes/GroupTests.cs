namespace RayCaster.Engine.Tests.Rendering.Meshes;

/// <summary>What is found out about triangles that follow one another, several at once, is what is found out about each of them.</summary>
public class GroupTests
{
    private static readonly Camera camera = new(new(new(5, 0.4, 0.3), Vector3.Zero) { Width = 640, Height = 480 });

    /// <summary>Otherwise a tile's groups would be drawn with the far side of its other triangles.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    public void AGroupIsSeenTheWayAroundThatItsTrianglesAre(int turn)
    {
        var (vertices, indices) = Specks(TriangleCluster.Length, turn);
        var (screen, tile) = (new ScreenSpace(camera), new Tile(320, 192, 64, 64));
        var corners = new MeshCorners<Packet>(screen, vertices, indices);
        var inGroups = new ScreenTriangles<Packet>(
            screen, corners, null, each => new ClusterSorter<Packet>(screen, vertices, indices, each), null, 1);
        var oneByOne = new ScreenTriangles<Packet>(screen, corners, null, null, null, 1);
        int[] sides = [0, 1];
        Assert.Equal(TriangleCluster.Length, sides.Max(side => oneByOne.Of(tile, side).Length));
        Assert.Equal(1, sides.Sum(side => inGroups.ClustersOf(tile, side).Length));
        Assert.Equal(Array.FindIndex(sides, side => oneByOne.Of(tile, side).Length > 0),
            Array.FindIndex(sides, side => inGroups.ClustersOf(tile, side).Length > 0));
    }

    [Theory]
    [InlineData(1)]
    [InlineData(7)]
    [InlineData(16)]
    [InlineData(19)]
    public void ARunOfTrianglesIsSeenWhereEachOfThemIs(int count)
    {
        var (vertices, indices) = Specks(count, 0);
        var corners = new MeshCorners<Packet>(new(camera), vertices, indices);
        for (var first = 0; first < count; first += 8)
        {
            int[] ids = [.. Enumerable.Range(first, 8).Select(i => Math.Min(i, count - 1))];
            corners.See(ids, out var each);
            corners.SeeRun(first, out var run);
            Assert.Equal([each.A.X, each.A.Y, each.A.W, each.B.X, each.B.Y, each.B.W], [run.A.X, run.A.Y, run.A.W, run.B.X, run.B.Y, run.B.W]);
            Assert.Equal([each.C.X, each.C.Y, each.C.W], [run.C.X, run.C.Y, run.C.W]);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(15)]
    [InlineData(16)]
    public void TheBoxOfAGroupReachesToEachOfItsCorners(int count)
    {
        var (vertices, indices) = Specks(40, 0);
        var (low, high) = new TriangleBoxes(vertices, indices).Around(8, 8 + count);
        Vector3[] corners = [.. indices[24..(24 + 3 * count)].Select(i => vertices[i])];
        Assert.Equal([corners.Min(p => p.X), corners.Min(p => p.Y), corners.Min(p => p.Z)], [low[0], low[1], low[2]]);
        Assert.Equal([corners.Max(p => p.X), corners.Max(p => p.Y), corners.Max(p => p.Z)], [high[0], high[1], high[2]]);
    }

    /// <summary>Behind the last vertex of the array there is no number to read with it.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    public void TheBoxOfAGroupWithTheLastVertexIsThatOfItsCorners(int spare)
    {
        var (vertices, indices) = Specks(16, 0);
        var (low, high) = new TriangleBoxes([.. vertices, .. new Vector3[spare]], indices).Around(0, 16);
        Assert.Equal([vertices.Min(p => p.X), vertices.Min(p => p.Y), vertices.Min(p => p.Z)], [low[0], low[1], low[2]]);
        Assert.Equal([vertices.Max(p => p.X), vertices.Max(p => p.Y), vertices.Max(p => p.Z)], [high[0], high[1], high[2]]);
    }

    [Fact]
    public void ACornerThatIsNoNumberLeavesTheBoxOfTheOthers()
    {
        Vector3[] vertices = [new(1, 2, 3), new(double.NaN, double.NaN, double.NaN), new(4, 0, 5)];
        var (low, high) = new TriangleBoxes(vertices, [1, 0, 2]).Around(0, 1);
        Assert.Equal([1.0, 0, 3, 4, 2, 5], [low[0], low[1], low[2], high[0], high[1], high[2]]);
    }

    [Theory]
    [InlineData(0, -1)]
    [InlineData(0, int.MinValue)]
    [InlineData(47, 48)]
    [InlineData(49, 54)] // of the last two triangles, which are less than can be checked at once
    [InlineData(53, int.MaxValue)]
    public void ACornerThatIsNotThereIsFoundBeforeItIsRead(int place, int index)
    {
        var (vertices, indices) = Specks(18, 0);
        indices[place] = index;
        if (index == 48) vertices = vertices[..48];
        var scene = new Scene(camera, [new Mesh(vertices, indices)]);
        Assert.Throws<IndexOutOfRangeException>(() => new Renderer(scene, 1).CastHits());
    }

    /// <summary>Small triangles about the origin, all seen the same way around.</summary>
    private static (Vector3[] Vertices, int[] Indices) Specks(int count, int turn)
    {
        var random = new Random(count);
        var vertices = new Vector3[3 * count];
        for (var i = 0; i < count; i++)
        {
            Vector3 At(double y, double z) => new(0.01 * random.NextDouble(), 0.05 + 0.01 * i % 0.04 + y, 0.02 + z);
            (vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]) = (At(0, 0), At(0.02, 0), At(0, 0.02));
            if (turn == 1) (vertices[3 * i], vertices[3 * i + 1]) = (vertices[3 * i + 1], vertices[3 * i]);
        }
        return (vertices, [.. Enumerable.Range(0, 3 * count)]);
    }
}
