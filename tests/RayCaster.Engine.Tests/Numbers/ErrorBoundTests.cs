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

    [Fact]
    public void WithoutTheBoundSomeBytesWouldBeWrong()
    {
        Assert.SkipWhen(!FloatBytes.IsSupported, "no 256-bit vectors here");
        var random = new Random(4);
        var scene = new Scene(
            new Camera(new(20, 0, 0), Vector3.Zero, width: 1920, height: 1080), [Model.Of(new Plane(new(-5, 0, 0), new(1, 0, 0.2)))]);
        var plane = ((Model<Plane>)scene.Models[0]).Primitive;
        var wrong = 0;
        for (var i = 0; i < 100_000; i++)
        {
            var (column, row) = (random.Next(1920), random.Next(1080));
            double exact = Level<Scalar>(column, row).Value;
            if ((int)Level<FloatPacket>(column, row).Lanes[0] != (int)exact) wrong++;
        }
        Assert.NotEqual(0, wrong);

        N Level<N>(N column, N row) where N : struct, IReal<N> =>
            Color.Level(scene.Attenuation(plane.Intersect(new Ray<N>(scene.Camera.Position, scene.Camera.Direction(column, row))).Near));
    }

    [Fact]
    public void WhereFloatsAndDoublesMayDisagreeNothingIsSaid()
    {
        ErrorBound one = 1, nearlyOne = ErrorBound.From(1 + 1e-9, 1 + 1e-9);
        Assert.Equal((0, 1), (one < nearlyOne) is var less ? (less.Lo, less.Hi) : default);
        Assert.Equal(double.PositiveInfinity, ErrorBound.Select(one < nearlyOne, one, one + one).Error);
        Assert.Equal(double.PositiveInfinity, ErrorBound.Sqrt(one - nearlyOne).Error);
        Assert.Equal(double.PositiveInfinity, (one / (one - nearlyOne)).Error);
        Assert.Equal(double.PositiveInfinity, ((ErrorBound)1e30 * 1e30).Error); // more than a float holds
    }
}
