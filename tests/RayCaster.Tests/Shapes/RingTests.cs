namespace RayCaster.Tests.Shapes;

/// <summary>A shape that somebody adds as a formula, tested where the answer is known by hand.</summary>
public class RingTests
{
    private readonly Ring ring = new(Vector3.Zero, new(1, 0, 0), 1, 2);

    [Theory]
    [InlineData(0.5, false)]
    [InlineData(1, true)]
    [InlineData(1.5, true)]
    [InlineData(2, true)]
    [InlineData(2.5, false)]
    public void ItIsHitBetweenItsRadii(double y, bool hit) =>
        Assert.Equal(hit ? 10 : (double?)null, Model.Of(ring).Intersect(new Ray(new(10, y, 0), new(-1, 0, 0))));
}
