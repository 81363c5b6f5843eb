namespace RayCaster.Tests.Shapes;

public class AabbTests
{
    private static readonly Aabb box = new(new(-1, -2, -3), new(1, 2, 3));

    [Theory]
    [InlineData(1, 0, 0, 9, 11)]
    [InlineData(-1, 0, 0, 9, 11)]
    [InlineData(0, 1, 0, 8, 12)]
    [InlineData(0, -1, 0, 8, 12)]
    [InlineData(0, 0, 1, 7, 13)]
    [InlineData(0, 0, -1, 7, 13)]
    public void ARayAlongAnAxisEntersAndLeavesAtTheFaces(double x, double y, double z, double near, double far) =>
        RayAssert.Crosses(box, -10 * new Vector3(x, y, z), new(x, y, z), near, far);

    [Fact]
    public void ACornerBelongsToTheBox()
    {
        var cube = new Aabb(new(-1, -1, -1), new(1, 1, 1));
        RayAssert.Crosses(cube, new(5, 5, 1), new(-1, -1, 0), 4 * Math.Sqrt(2), 6 * Math.Sqrt(2), 1e-14);
    }

    [Fact]
    public void FromInsideTheFarFaceIsHit() => RayAssert.Hits(box, new(0, 0, 0), new(0, 0, 1), 3);

    [Fact]
    public void BehindTheOriginIsNoHit() => RayAssert.Hits(box, new(5, 0, 0), new(1, 0, 0), null);

    [Theory]
    [InlineData(2)]
    [InlineData(-2)]
    public void ARayInAFaceIsInTheBoxWhateverTheSignOfItsZeros(double y)
    {
        foreach (var zero in new[] { 0.0, -0.0 }) RayAssert.Hits(box, new(-10, y, 0), new(1, zero, zero), 9);
    }

    [Fact]
    public void ARayAlongAnEdgeIsInTheBox() => RayAssert.Hits(box, new(-10, 2, -3), new(1, 0, 0), 9);

    [Fact]
    public void AParallelRayJustOutsideAFaceMisses() => RayAssert.Hits(box, new(-10, Math.BitIncrement(2), 0), new(1, 0, 0), null);

    [Fact]
    public void ARayThatStartsInAFaceLeavesByTheOther() => RayAssert.Crosses(box, new(-1, 0, 0), new(1, 0, 0), 0, 2);

    [Fact]
    public void ARayThatStartsAndStaysInAFaceLeavesAtItsEdge() => RayAssert.Crosses(box, new(1, 0, 0), new(0, 1, 0), -2, 2);

    [Fact]
    public void AFlatBoxIsHitFromItsFront() =>
        RayAssert.Crosses(new Aabb(new(-1, -1, 2), new(1, 1, 2)), new(0, 0, 6), new(0, 0, -1), 4, 4);

    [Fact]
    public void AFlatBoxIsHitByARayInItsPlane() =>
        RayAssert.Crosses(new Aabb(new(-1, -1, 2), new(1, 1, 2)), new(-5, 0, 2), new(1, 0, 0), 4, 6);

    [Fact]
    public void ARayInTheFaceThatTwoBoxesShareHitsThem()
    {
        RayAssert.Hits(new Aabb(new(-1, -1, -1), new(0, 1, 1)), new(0, -5, 0.5), new(0, 1, 0), 4);
        RayAssert.Hits(new Aabb(new(0, -1, -1), new(1, 1, 1)), new(0, -5, 0.5), new(0, 1, 0), 4);
    }
}
