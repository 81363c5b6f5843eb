namespace RayCaster.Files.Tests.Meshes;

public class MeshPlacementTests
{
    private static readonly Vector3 one = new(1, 1, 1);

    /// <summary>Products of a few smaller numbers are 0, so such a mesh would have holes, or not show.</summary>
    [Fact]
    public void AMeshThatIsTooSmallIsRefusedWithTheLimit()
    {
        MeshData triangle = new([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]), point = new([new(1, 1, 1)], [0, 0, 0]);
        var (small, least) = (new Vector3(1e-160, 1e-160, 1e-160), new Vector3(2e-100, 2e-100, 2e-100));
        Assert.Equal("the mesh is placed with a size of 1E-160, but the least size is 1e-100",
            Assert.Throws<OverflowException>(() => new MeshPlacement(small, Vector3.Zero, Vector3.Zero).Place(triangle, out _)).Message);
        Assert.Equal(1, new MeshPlacement(least, Vector3.Zero, Vector3.Zero).Place(triangle, out _).TriangleCount);
        new MeshPlacement(small, Vector3.Zero, Vector3.Zero).Place(point, out var dropped); // without any area it draws nothing, which is right
        Assert.Equal(1, dropped);
    }

    [Theory]
    [InlineData(90, 0, 0, 1, -3, 2)] // y → z → −y
    [InlineData(0, 90, 0, 3, 2, -1)] // z → x → −z
    [InlineData(0, 0, 90, -2, 1, 3)] // x → y → −x
    [InlineData(-90, 0, 0, 1, 3, -2)]
    [InlineData(0, 180, 0, -1, 2, -3)]
    [InlineData(0, 0, -180, -1, -2, 3)]
    [InlineData(450, -270, 720, 2, -3, -1)] // x: (1, −3, 2), then y: (2, −3, −1)
    [InlineData(90, 90, 90, 3, 2, -1)] // x: (1, −3, 2), y: (2, −3, −1), z: (3, 2, −1)
    public void QuarterTurnsAreExactAndRightHandedInTheOrderXYZ(double rx, double ry, double rz, double x, double y, double z) =>
        Assert.Equal(new(x, y, z), Place(new(1, 2, 3), new(one, new(rx, ry, rz), default)));

    [Fact]
    public void AnyAngleTurnsByTheClosedForms()
    {
        var third = Math.Sqrt(3) / 2; // sin 60°; cos 60° = 1/2
        AssertNear(new(1, 0.5 * 2 - third * 3, third * 2 + 0.5 * 3), Place(new(1, 2, 3), new(one, new(60, 0, 0), default)));
        AssertNear(new(0.5 * 1 + third * 3, 2, -third * 1 + 0.5 * 3), Place(new(1, 2, 3), new(one, new(0, 60, 0), default)));
        AssertNear(new(0.5 * 1 - third * 2, third * 1 + 0.5 * 2, 3), Place(new(1, 2, 3), new(one, new(0, 0, 60), default)));
        // Rz(30°) Ry(60°) Rx(0): (1, 0, 0) → (1/2, 0, −√3/2) → (√3/4, 1/4, −√3/2)
        AssertNear(new(third / 2, 0.25, -third), Place(new(1, 0, 0), new(one, new(0, 60, 30), default)));
    }

    [Fact]
    public void ScaleComesFirstAndTranslateLast() => // scale: (2, 6, 12), turn about z: (−6, 2, 12)
        Assert.Equal(new(94, 202, 312), Place(new(1, 2, 3), new(new(2, 3, 4), new(0, 0, 90), new(100, 200, 300))));

    [Fact]
    public void NegativeScaleMirrors() => Assert.Equal(new(-1, 2, 3), Place(new(1, 2, 3), new(new(-1, 1, 1), default, default)));

    [Theory]
    [InlineData(1e-30)]
    [InlineData(1)]
    [InlineData(1e30)]
    public void TrianglesOfNoAreaAreDroppedWhateverTheUnitOfLength(double scale)
    {
        Vector3[] vertices = [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(2, 0, 0), new(0.5, 1e-13, 0), new(0.5, 1e-11, 0)];
        int[] indices = [0, 1, 1, 0, 1, 2, 0, 1, 3, 0, 1, 4, 0, 1, 5, 2, 2, 2];
        var mesh = new MeshPlacement(scale * one, new(10, 20, 30), default).Place(new(vertices, indices), out var dropped);
        // Two corners in one place, three on one line, one 1e-13 of the longest side beside it, and three in one place.
        Assert.Equal((4, 2), (dropped, mesh.TriangleCount));
        Assert.Equal(1, mesh[0].C.Length / scale, 1e-12); // the second of the file is the first that is left
        Assert.Equal(0.5, mesh[1].C.Length / scale, 1e-12); // and the fifth the second
    }

    [Fact]
    public void AreaIsLookedForWhereTheMeshIsPlaced()
    {
        var mesh = new MeshPlacement(new(1, 1e-14, 1), default, default)
            .Place(new([new(0, 0, 0), new(1, 0, 0), new(0, 1, 0)], [0, 1, 2]), out var dropped);
        Assert.Equal((1, 0), (dropped, mesh.TriangleCount));
    }

    [Theory]
    [InlineData(1e308, 10, 0)]
    [InlineData(1e308, 1, 1.7e308)]
    [InlineData(1e101, 1, 0)]
    public void VertexBeyondTheLargestCoordinateIsRefused(double x, double scale, double translate) =>
        Assert.Throws<OverflowException>(() => Place(new(x, 0, 0), new(scale * one, default, new(translate, 0, 0))));

    /// <summary>Where a placement puts a point, seen as the corner of a triangle that is large enough to stay.</summary>
    private static Vector3 Place(Vector3 point, MeshPlacement placement) =>
        placement.Place(new([point, new(9, 0, 0), new(0, 9, 0)], [0, 1, 2]), out _)[0].A;

    private static void AssertNear(Vector3 expected, Vector3 actual) => Assert.InRange((expected - actual).Length, 0, 1e-15);
}
