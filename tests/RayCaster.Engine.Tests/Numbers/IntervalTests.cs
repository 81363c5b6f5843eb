using Range = RayCaster.Engine.Interval;

namespace RayCaster.Engine.Tests.Numbers;

/// <summary>The primitives' own formulas over intervals give what a whole region of rays can meet.</summary>
public class IntervalTests
{
    public static TheoryData<string> Shapes => new(Primitives.Keys);

    internal static readonly Dictionary<string, IPrimitive> Primitives = new()
    {
        ["plane"] = new Plane(new(-5, 0, 0), new(1, 0, 0.2)),
        ["sphere"] = new Sphere(new(0, 1, -1), 2),
        ["aabb"] = new Aabb(new(-2, -1, -1), new(1, 2, 1)),
        ["circle"] = new Circle(new(1, 0, 0), new(1, 0.3, 0), 2),
        ["triangle"] = new Triangle(new(0, -2, -1), new(0, 2, -1), new(1, 0, 3)),
    };

    [Theory]
    [MemberData(nameof(Shapes))]
    public void AnIntervalHoldsTheCrossingsOfEveryRayInIt(string shape)
    {
        var random = new Random(7);
        for (var i = 0; i < 300; i++)
        {
            var (y, z) = (random.NextDouble() - 0.5, random.NextDouble() - 0.5);
            var region = Region(y, z, Math.Pow(2, -random.Next(1, 8)));
            var bounds = Primitives[shape].Intersect(region);
            for (var j = 0; j < 30; j++)
            {
                var d = new Vector3(Inside(region.Direction.X), Inside(region.Direction.Y), Inside(region.Direction.Z));
                var crossings = Primitives[shape].Intersect(new Ray<Scalar>(new Vector3(20, 0, 0), d));
                Assert.True(Contains(bounds.Near, crossings.Near),
                    $"near {crossings.Near} of the ray along {d} is not in {Lo(bounds.Near)} … {Hi(bounds.Near)}");
                Assert.True(
                    Contains(bounds.Far, crossings.Far), $"far {crossings.Far} of the ray along {d} is not in {Lo(bounds.Far)} … {Hi(bounds.Far)}");
            }
        }

        double Inside(Range x) => Lo(x) + random.NextDouble() * (Hi(x) - Lo(x));
    }

    [Fact]
    public void WhereAnEndIsInfiniteTheProductMayBeNoNumber()
    {
        var (aroundZero, unlimited) = (new Range(-1, 1), new Range(1, double.PositiveInfinity));
        Assert.True(Contains(aroundZero * unlimited, 0 * double.PositiveInfinity));
        Assert.True(Contains(unlimited - unlimited, double.PositiveInfinity - double.PositiveInfinity));
        Assert.True(Contains(unlimited / unlimited, double.PositiveInfinity / double.PositiveInfinity));
    }

    /// <summary>Some rays of the region fall onto the plane, some rise from it, and those between run along it.</summary>
    [Fact]
    public void RaysAlongAPlaneCrossItFarAway()
    {
        var random = new Random(5);
        var floor = new Plane(new(0, -5, 0), new(0, 1, 0));
        var t = floor.Intersect(Region(0.001, 0, 0.01)).Near;
        Assert.InRange(Gap(t), 500, 5 / 0.006 + 1e-9);
        for (var i = 0; i < 1000; i++)
        {
            var d = new Vector3(-1, 0.001 + 0.01 * (random.NextDouble() - 0.5), 0);
            Assert.True(Contains(t, floor.Intersect(new Ray<Scalar>(new Vector3(20, 0, 0), d)).Near));
        }
    }

    private static bool Contains(Range range, double x) =>
        Lanes.All(range.IsAlwaysNaN) ? double.IsNaN(x)
            : double.IsNaN(x) ? Lanes.All(range.MayBeNaN) : Lo(range) <= x && x <= Hi(range) && Math.Abs(x) >= Gap(range);

    private static double Lo(Range range) => range.Lo.Lanes[0];

    private static double Hi(Range range) => range.Hi.Lanes[0];

    private static double Gap(Range range) => range.Gap.Lanes[0];

    /// <summary>The rays from (20, 0, 0) towards −x that lie about (y, z) on the picture plane; their directions need not have length 1 to be a
    /// test.</summary>
    private static Ray<Range> Region(double y, double z, double size) => new(
        new Vector3(20, 0, 0),
        new Vector3<Range>(new(-1 - size / 8, -1 + size / 8), new(y - size / 2, y + size / 2), new(z - size / 2, z + size / 2)));
}
