namespace RayCaster.Tests.Shapes;

public class CircleTests
{
    private static readonly Circle circle = new(new(0, 0, 0), new(0, 0, 1), 5);

    [Theory]
    [InlineData(10, -1)]
    [InlineData(-10, 1)]
    public void BothSidesAreVisible(double z, double direction) => RayAssert.Hits(circle, new(1, 2, z), new(0, 0, direction), 10);

    [Fact]
    public void TheRimBelongsToIt() => RayAssert.Hits(circle, new(3, -4, 10), new(0, 0, -1), 10);

    [Fact]
    public void JustOutsideTheRimIsNoHit() => RayAssert.Hits(circle, new(3, Math.BitIncrement(4), 10), new(0, 0, -1), null);

    [Theory]
    [InlineData(1)]
    [InlineData(0)]
    public void AParallelRayDoesNotHit(double z) => RayAssert.Hits(circle, new(-10, 0, z), new(1, 0, 0), null);

    [Theory]
    [InlineData(1e-200)]
    [InlineData(-1e200)]
    public void TheLengthOfTheNormalDoesNotMatter(double length) =>
        RayAssert.Hits(circle with { Normal = new(0, 0, length) }, new(3, 4, 10), new(0, 0, -1), 10);
}
