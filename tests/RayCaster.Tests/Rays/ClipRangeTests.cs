namespace RayCaster.Tests.Rays;

public class ClipRangeTests
{
    private static bool Counts(ClipRange range, double t, double depthPerT = 1) => range.CountsMask<Scalar>(t, depthPerT) != 0;

    [Fact]
    public void WithABiasOf0TheOriginCounts() => Assert.True(Counts(new(0, 0, 100), 0) && Counts(new(0, 0, 100), -0.0));

    [Fact]
    public void WithABiasOf0NothingBehindTheOriginCounts() => Assert.False(Counts(new(0, 0, 100), -double.Epsilon));

    [Fact]
    public void TheBiasItselfDoesNotCount() => Assert.False(Counts(new(1e-6, 0, 100), 1e-6));

    [Fact]
    public void TheNextNumberBeyondTheBiasCounts() => Assert.True(Counts(new(1e-6, 0, 100), Math.BitIncrement(1e-6)));

    [Theory]
    [InlineData(2, true)]
    [InlineData(5, true)]
    [InlineData(1.9999999999999998, false)]
    [InlineData(5.000000000000001, false)]
    [InlineData(double.NaN, false)]
    [InlineData(double.PositiveInfinity, false)]
    [InlineData(double.NegativeInfinity, false)]
    public void BothEndsOfTheRangeCount(double t, bool counts) => Assert.Equal(counts, Counts(new(1e-6, 2, 5), t));

    [Fact]
    public void InfinityDoesNotCountHoweverFarTheRangeReaches() => Assert.False(Counts(ClipRange.Everything, double.PositiveInfinity));

    [Theory]
    [InlineData(4, true)]
    [InlineData(10, true)]
    [InlineData(3.999, false)]
    [InlineData(10.001, false)]
    public void DepthIsMeasuredAcrossTheView(double t, bool counts) => Assert.Equal(counts, Counts(new(1e-6, 2, 5), t, 0.5));

    [Fact]
    public void TheBiasIsMeasuredAlongTheRay() => Assert.True(Counts(new(3, 2, 5), 4, 0.5)); // its z of 2 is less than the bias

    [Theory]
    [InlineData(3, 4, 3)]
    [InlineData(1, 4, 4)]
    [InlineData(-1, 4, 4)]
    [InlineData(1, 6, double.NaN)]
    [InlineData(6, 7, double.NaN)]
    [InlineData(3, double.NaN, 3)]
    [InlineData(double.NaN, double.NaN, double.NaN)]
    public void TheFirstCrossingThatCountsIsTheHit(double near, double far, double hit) =>
        Assert.Equal(hit, (double)new ClipRange(0, 2, 5).First(new Crossings<Scalar>(near, far), (Scalar)1));
}
