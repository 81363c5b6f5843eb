namespace RayCaster.Tests.Models;

public class SphereTests
{
    private static readonly Sphere sphere = new(new(1, 0, 0), 2);

    [Fact]
    public void FromOutsideBothSidesAreCrossed() => Assert.Equal((2, 6), Cast.Line(sphere, new(5, 0, 0), new(-1, 0, 0)));

    [Fact]
    public void FromInsideTheFarSideIsHit() => Assert.Equal(3, Cast.At(sphere, new(2, 0, 0), new(-1, 0, 0)));

    [Fact]
    public void FromItsCentreEveryWayIsOneRadiusLong()
    {
        var random = new Random(1);
        for (var i = 0; i < 1000; i++) Assert.Equal(2, Cast.At(sphere, sphere.Center, Some.Direction(random)));
    }

    [Fact]
    public void BehindTheOriginIsNoHit() => Assert.Null(Cast.At(sphere, new(5, 0, 0), new(1, 0, 0)));

    [Fact]
    public void ATouchingRayCrossesTwiceAtOnePoint() => Assert.Equal((4, 4), Cast.Line(sphere, new(5, 2, 0), new(-1, 0, 0)));

    [Fact]
    public void ARayThatPassesByHasNoCrossing() =>
        Assert.Equal((double.NaN, double.NaN), Cast.Line(sphere, new(5, Math.BitIncrement(2), 0), new(-1, 0, 0)));

    [Fact]
    public void WhereTheNearSideIsClippedAwayTheFarSideShows()
    {
        var ray = new Ray(new(5, 0, 0), new(-1, 0, 0)) { ClipRange = new ClipRange(0, 3, 100) };
        Assert.Equal(6, Model.Of(sphere).Intersect(ray));
    }

    [Fact]
    public void TheGeometricAndTheAnalyticalSolutionAgree()
    {
        var random = new Random(2);
        var hits = 0;
        for (var i = 0; i < 20_000; i++)
        {
            var shape = new Sphere(Some.Point(random, 10), 0.1 + 5 * random.NextDouble());
            var (origin, d) = (Some.Point(random, 20), Some.Direction(random));
            if (i % 2 == 0) d = (shape.Center + Some.Point(random, shape.Radius) - origin).Normalized;
            var b = (origin - shape.Center) * d;
            var c = (origin - shape.Center) * (origin - shape.Center) - shape.Radius * shape.Radius;
            var discriminant = b * b - c;
            if (Math.Abs(discriminant) < 1e-3) continue; // near the outline few digits are left in either

            var (near, far) = Cast.Line(shape, origin, d);
            var analytical = shape.IntersectAnalytically(new Ray<Scalar>(origin, d));
            if (discriminant < 0)
            {
                Assert.All(
                    new double[] { near, far, analytical.Near, analytical.Far },
                    t => Assert.True(double.IsNaN(t), $"{shape} from {origin} along {d}: {t}"));
                continue;
            }
            hits++;
            Assert.Equal(-b - Math.Sqrt(discriminant), near, 1e-10);
            Assert.Equal(-b + Math.Sqrt(discriminant), far, 1e-10);
            Assert.Equal(near, analytical.Near, 1e-10);
            Assert.Equal(far, analytical.Far, 1e-10);
        }
        Assert.InRange(hits, 500, 19_500);
    }

    /// <summary>By Pythagoras a ray that passes the centre at 0.8 R is inside for 0.6 R before and after, however far away it starts.</summary>
    [Theory]
    [InlineData(1e3)]
    [InlineData(1e6)]
    [InlineData(1e9)]
    public void AFarSphereKeepsItsShape(double distance) =>
        Assert.Equal((distance - 0.75, distance + 0.75), Cast.Line(new Sphere(new(distance, 0, 0), 1.25), new(0, 1, 0), new(1, 0, 0)));
}
