namespace RayCaster.Tests.Shapes;

public class PlaneTests
{
    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    [InlineData(1e-200)]
    [InlineData(-1e200)]
    public void TheLengthAndTheSideOfTheNormalDoNotMatter(double length) =>
        RayAssert.Hits(new Plane(new(5, 7, -9), length * new Vector3(1, 0, 0)), new(20, 0, 0), new(-1, 0, 0), 15, 1e-14);

    [Fact]
    public void ASlantedRayMeetsItWhereTheFormulaSays() => // 3-4-5: 4 down along z takes 5 of t
        RayAssert.Hits(new Plane(new(0, 0, 0), new(0, 0, 1)), new(0, 0, 4), new(3, 0, -4), 5, 1e-14);

    [Theory]
    [InlineData(1)]
    [InlineData(0)] // in the plane
    [InlineData(-1)]
    public void AParallelRayDoesNotHit(double height) =>
        RayAssert.Hits(new Plane(new(0, 0, 0), new(0, 0, 1)), new(0, 0, height), new(1, 2, 0), null);

    [Fact]
    public void BehindTheOriginIsNoHit() => RayAssert.Hits(new Plane(new(5, 0, 0), new(1, 0, 0)), new(4, 0, 0), new(-1, 0, 0), null);

    [Fact]
    public void ItIsCrossedOnce() => RayAssert.Crosses(new Plane(new(5, 0, 0), new(1, 0, 0)), default, new(1, 0, 0), 5, double.NaN);
}
