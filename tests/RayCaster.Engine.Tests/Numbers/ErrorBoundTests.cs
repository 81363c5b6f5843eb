namespace RayCaster.Engine.Tests.Numbers;

/// <summary>Floats are no farther from doubles than the primitives' own formulas over rounded numbers say.</summary>
public class ErrorBoundTests
{
    public static TheoryData<string> Shapes => IntervalTests.Shapes;

    [Theory]
    [MemberData(nameof(Shapes))]
    public void TheErrorOfNoFloatIsGreaterThanItsBound(string shape)
    {
        Assert.SkipWhen(!FloatBytes.IsSupported, "no 256-bit vectors here");
        var random = new Random(3);
        var (bounded, worst) = (0, 0.0);
        var origin = new Vector3(20, 0.1, -0.3);
        for (var i = 0; i < 400; i++)
        {
            var (y, z, size) = (0.3 * (random.NextDouble() - 0.5), 0.3 * (random.NextDouble() - 0.5), Math.Pow(2, -random.Next(4, 9)));
            var region = new Vector3<ErrorBound>(ErrorBound.From(-1 - size, -1), ErrorBound.From(y, y + size), ErrorBound.From(z, z + size));
            var bound = IntervalTests.Primitives[shape].Intersect(new Ray<ErrorBound>(origin, region)).Near;
            if (bound.Error == double.PositiveInfinity) continue;
            bounded++;
            for (var j = 0; j < 20; j++)
            {
                var d = new Vector3(-1 - random.NextDouble() * size, y + random.NextDouble() * size, z + random.NextDouble() * size);
                double exact = IntervalTests.Primitives[shape].Intersect(new Ray<Scalar>(origin, d)).Near;
                var rough = IntervalTests.Primitives[shape].Intersect(new Ray<FloatPacket>(origin, (Vector3)d)).Near;
                var error = Math.Abs(rough.Lanes[random.Next(FloatPacket.Count)] - exact);
                Assert.True(error <= bound.Error, $"off by {error} for {d}, where {bound.Error} was said to be the most");
                worst = Math.Max(worst, error / bound.Error);
            }
        }
        Assert.True(bounded > 20, $"only {bounded} regions have a bound");
        Assert.True(worst > 0.02, $"the bound is {1 / worst} times what is needed");
    }
}
