using System.Runtime.Intrinsics;

namespace RayCaster.Engine.Tests.Rendering;

/// <summary>Where floats may round a level to the other side of a whole number, the margins say so, and they are not much greater than
/// that.</summary>
public class FloatBytesTests
{
    [Fact]
    public void TheEndsOfALineHoldTheLevelOfDoubles()
    {
        Assert.SkipWhen(!FloatBytes.IsSupported, "no 256-bit vectors here");
        var (random, closest) = (new Random(6), double.PositiveInfinity);
        for (var i = 0; i < 100_000; i++)
        {
            var (channel, reach) = (random.NextDouble(), 0.1 + 100 * random.NextDouble());
            var t = (float)(reach * random.NextDouble() * 0.999);
            double level = Color.Level<Scalar>((1 - t / reach) * channel);
            var line = new FloatLevel(channel, reach, 0);
            var ofLeast = line.Least(Vector256.Create(t));
            var (least, most) = (ofLeast[0], line.Most(ofLeast)[0]);
            Assert.True(least <= level && level <= most, $"{level} is not between {least} and {most}");
            closest = Math.Min(closest, Math.Min(level - least, most - level));
        }
        Assert.InRange(closest, 0, 0.7 * FloatBytes.RoundingOfALine);
    }

    [Fact]
    public void MovingALevelByItsErrorRoundsNoMoreThanIsSaid()
    {
        var (random, worst) = (new Random(7), 0.0);
        for (var i = 0; i < 100_000; i++)
        {
            var (level, slack) = ((float)(255.5 * random.NextDouble()), (float)(1e-3 * random.NextDouble()));
            worst = Math.Max(worst, Math.Abs((double)(level - slack) - ((double)level - slack)));
        }
        Assert.InRange(worst, 0.9 * FloatBytes.RoundingOfTheEnds, FloatBytes.RoundingOfTheEnds);
    }
}
