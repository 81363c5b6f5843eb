using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slides "Plane", "Ray – Plane Intersection".</summary>
[Trait("step", "3")]
public class Step03Plane : StepTests
{
    private const string Slide = "Ray – Plane Intersection";

    private readonly Chance chance = new();

    private static Library.Model PlaneOf(Library.Vector3 Q, Library.Vector3 n) => Library.Model.Of(new Library.Plane(Q, n));

    [Fact]
    public void TheSlidesNumbers() => RayAssert.Hits(Slide, PlaneOf(new(-5, 0, 0), new(1, 0, 0)), new(20, 0, 0), new(-1, 0, 0), 25);

    [Fact]
    public void BothSidesAreSeen()
    {
        RayAssert.Hits(Slide, PlaneOf(default, new(1, 0, 0)), new(3, 0, 0), new(-1, 0, 0), 3);
        RayAssert.Hits(Slide, PlaneOf(default, new(1, 0, 0)), new(-3, 0, 0), new(1, 0, 0), 3);
    }

    [Fact]
    public void TheNormalMayHaveAnyLength() => RayAssert.Hits(Slide, PlaneOf(default, new(0, 0, 50)), new(0, 0, 3), new(0, 0, -1), 3);

    [Fact]
    public void APlaneBehindIsNotHit() => RayAssert.Hits(Slide, PlaneOf(new(25, 0, 0), new(1, 0, 0)), new(20, 0, 0), new(-1, 0, 0), null);

    [Fact]
    public void AParallelRayHitsNothing() => RayAssert.Hits(Slide, PlaneOf(default, new(0, 0, 1)), new(0, 0, 1), new(1, 0, 0), null);

    [Fact]
    public void ARayInThePlaneHitsNothing() => RayAssert.Hits(Slide, PlaneOf(default, new(0, 0, 1)), new(5, 5, 0), new(1, 0, 0), null);

    [Fact]
    public void RandomRays()
    {
        for (var i = 0; i < Teacher.Rays; i++) RayAssert.Agrees(Slide, PlaneOf(chance.Point(), chance.Direction()), chance.Point(), chance.Point());
    }
}
