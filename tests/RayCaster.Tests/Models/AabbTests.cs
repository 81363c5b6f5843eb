namespace RayCaster.Tests.Models;

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
        Assert.Equal((near, far), Cast.Line(box, -10 * new Vector3(x, y, z), new(x, y, z)));

    [Fact]
    public void ACornerBelongsToTheBox()
    {
        var cube = new Aabb(new(-1, -1, -1), new(1, 1, 1));
        var (near, far) = Cast.Line(cube, new(5, 5, 1), new(-1, -1, 0));
        Assert.Equal(4 * Math.Sqrt(2), near, 1e-14);
        Assert.Equal(6 * Math.Sqrt(2), far, 1e-14);
    }

    [Fact]
    public void FromInsideTheFarFaceIsHit() => Assert.Equal(3, Cast.At(box, new(0, 0, 0), new(0, 0, 1)));

    [Fact]
    public void BehindTheOriginIsNoHit() => Assert.Null(Cast.At(box, new(5, 0, 0), new(1, 0, 0)));

    [Theory]
    [InlineData(2)]
    [InlineData(-2)]
    public void ARayInAFaceIsInTheBoxWhateverTheSignOfItsZeros(double y)
    {
        foreach (var zero in new[] { 0.0, -0.0 }) Assert.Equal(9, Cast.At(box, new(-10, y, 0), new(1, zero, zero)));
    }

    [Fact]
    public void ARayAlongAnEdgeIsInTheBox() => Assert.Equal(9, Cast.At(box, new(-10, 2, -3), new(1, 0, 0)));

    [Fact]
    public void AParallelRayJustOutsideAFaceMisses() => Assert.Null(Cast.At(box, new(-10, Math.BitIncrement(2), 0), new(1, 0, 0)));

    [Fact]
    public void ARayThatStartsInAFaceLeavesByTheOther() => Assert.Equal((0, 2), Cast.Line(box, new(-1, 0, 0), new(1, 0, 0)));

    [Fact]
    public void ARayThatStartsAndStaysInAFaceLeavesAtItsEdge() => Assert.Equal((-2, 2), Cast.Line(box, new(1, 0, 0), new(0, 1, 0)));

    [Fact]
    public void AFlatBoxIsHitFromItsFront() =>
        Assert.Equal((4, 4), Cast.Line(new Aabb(new(-1, -1, 2), new(1, 1, 2)), new(0, 0, 6), new(0, 0, -1)));

    [Fact]
    public void AFlatBoxIsHitByARayInItsPlane() =>
        Assert.Equal((4, 6), Cast.Line(new Aabb(new(-1, -1, 2), new(1, 1, 2)), new(-5, 0, 2), new(1, 0, 0)));

    [Fact]
    public void ARayInTheFaceThatTwoBoxesShareHitsThem()
    {
        var (left, right) = (new Aabb(new(-1, -1, -1), new(0, 1, 1)), new Aabb(new(0, -1, -1), new(1, 1, 1)));
        Assert.Equal((4.0, 4.0), (Cast.At(left, new(0, -5, 0.5), new(0, 1, 0)), Cast.At(right, new(0, -5, 0.5), new(0, 1, 0))));
    }
}
