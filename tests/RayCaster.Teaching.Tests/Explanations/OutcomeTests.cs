namespace RayCaster.Teaching.Tests.Explanations;

public class OutcomeTests
{
    [Theory]
    [InlineData(3, Outcome.Shows)]
    [InlineData(double.NaN, Outcome.Misses)]
    [InlineData(double.PositiveInfinity, Outcome.Misses)]
    [InlineData(-0.1, Outcome.Behind)]
    [InlineData(0, Outcome.UnderBias)]
    [InlineData(1e-6, Outcome.UnderBias)]
    [InlineData(1.9, Outcome.BeforeNear)]
    [InlineData(5.1, Outcome.BeyondFar)]
    public void ACrossingThatDoesNotCountHasAReason(double t, Outcome outcome) =>
        Assert.Equal(outcome, Of(t, new(1e-6, 2, 5), 1));

    [Fact]
    public void ACrossingShowsExactlyWhereTheClipRangeCountsIt()
    {
        double[] numbers = [
            double.NaN, double.NegativeInfinity, -5, -1e-300, -0.0, 0, 1e-300, 0.5, 1, 2, 5, 1e300, double.MaxValue, double.PositiveInfinity];
        ClipRange[] ranges = [ClipRange.Everything, new(0, 0, 5), new(0.5, 0, 5), new(1, 1, 2), new(0, 2, double.MaxValue)];
        foreach (var range in ranges)
            foreach (var t in numbers)
                foreach (var depthPerT in (double[])[0, 0.5, 1, -1])
                    Assert.Equal(range.CountsMask<Scalar>(t, depthPerT) != 0, Of(t, range, depthPerT) == Outcome.Shows);
    }

    private static Outcome Of(double t, ClipRange clip, double depthPerT) =>
        Outcomes.Classify(t, new Ray(Vector3.Zero, new(1, 0, 0)) { ClipRange = clip, DepthPerT = depthPerT });
}
