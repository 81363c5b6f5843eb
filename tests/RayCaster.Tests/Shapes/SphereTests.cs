namespace RayCaster.Tests.Shapes;

public class SphereTests
{
    private static readonly Sphere sphere = new(new(1, 0, 0), 2);

    [Fact]
    public void FromOutsideBothSidesAreCrossed() => RayAssert.Crosses(sphere, new(5, 0, 0), new(-1, 0, 0), 2, 6);

    [Fact]
    public void FromInsideTheFarSideIsHit() => RayAssert.Hits(sphere, new(2, 0, 0), new(-1, 0, 0), 3);

    [Fact]
    public void FromItsCentreEveryWayIsOneRadiusLong()
    {
        var random = new Random(1);
        for (var i = 0; i < 1000; i++) RayAssert.Hits(sphere, sphere.Center, Some.Direction(random), 2);
    }

    [Fact]
    public void BehindTheOriginIsNoHit() => RayAssert.Hits(sphere, new(5, 0, 0), new(1, 0, 0), null);

    [Fact]
    public void ATouchingRayCrossesTwiceAtOnePoint() => RayAssert.Crosses(sphere, new(5, 2, 0), new(-1, 0, 0), 4, 4);

    [Fact]
    public void ARayThatPassesByHasNoCrossing() =>
        RayAssert.Crosses(sphere, new(5, Math.BitIncrement(2), 0), new(-1, 0, 0), double.NaN, double.NaN);

    [Fact]
    public void WhereTheNearSideIsClippedAwayTheFarSideShows()
    {
        var ray = new Ray(new(5, 0, 0), new(-1, 0, 0)) { ClipRange = new ClipRange(0, 3, 100) };
        RayAssert.HitsAlong(sphere, ray, 6);
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

            var root = Math.Sqrt(discriminant); // NaN where the ray passes by
            RayAssert.Crosses(shape, origin, d, -b - root, -b + root, 1e-10);
            if (discriminant >= 0) hits++;
        }
        Assert.InRange(hits, 500, 19_500);
    }

    /// <summary>By Pythagoras a ray that passes the centre at 0.8 R is inside for 0.6 R before and after, however far away it starts.</summary>
    [Theory]
    [InlineData(1e3)]
    [InlineData(1e6)]
    [InlineData(1e9)]
    public void AFarSphereKeepsItsShape(double distance) =>
        RayAssert.Crosses(new Sphere(new(distance, 0, 0), 1.25), new(0, 1, 0), new(1, 0, 0), distance - 0.75, distance + 0.75);
}
