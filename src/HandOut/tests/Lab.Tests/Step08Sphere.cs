using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slides "Sphere", "Sphere – Geometric Solution", "Sphere – Analytical Solution": both ways lead to the same intersections.</summary>
[Trait("step", "8")]
public class Step08Sphere : StepTests
{
    private const string Geometric = "Sphere – Geometric Solution", Analytical = "Sphere – Analytical Solution";

    private readonly Chance chance = new();

    private static Library.Model SphereOf(Library.Vector3 C, double R) => Library.Model.Of(new Library.Sphere(C, R));

    private static Action<Model, Ray> By(string way) =>
        way == Analytical ? (sphere, ray) => ((Sphere)sphere).AnalyticalSolution(ray)
            : (sphere, ray) => ((Sphere)sphere).GeometricSolution(ray);

    [Theory]
    [InlineData(Geometric)]
    [InlineData(Analytical)]
    public void StraightOn(string way)
    {
        RayAssert.Hits(way, SphereOf(default, 4), new(20, 0, 0), new(-1, 0, 0), 16, By(way));
        RayAssert.Hits(way, SphereOf(new(0, 4, -4), 4), new(20, 4, -4), new(-1, 0, 0), 16, By(way));
        RayAssert.Hits(way, SphereOf(new(0, 3, 0), 5), new(20, 0, 0), new(-1, 0, 0), 16, By(way)); // 3, 4, 5
    }

    /// <summary>Its formula, with a = d·d, holds for a d of any length: "/ 2 * a" in place of "/ (2 * a)" is wrong only there.</summary>
    [Fact]
    public void TheAnalyticalSolutionDividesByA()
    {
        RayAssert.Hits(Analytical, SphereOf(default, 4), new(20, 0, 0), new(-2, 0, 0), 8, By(Analytical));
    }

    [Theory]
    [InlineData(Geometric)]
    [InlineData(Analytical)]
    public void ARayThatPassesByHitsNothing(string way) => RayAssert.Hits(way, SphereOf(default, 1), new(5, 1.1, 0), new(-1, 0, 0), null, By(way));

    [Theory]
    [InlineData(Geometric)]
    [InlineData(Analytical)]
    public void FromInsideAndCutOpenByZNearTheFarSideShows(string way)
    {
        RayAssert.Hits(way, SphereOf(default, 3), new(1, 0, 0), new(-1, 0, 0), 4, By(way));
        RayAssert.Hits(way, SphereOf(default, 3), new(1, 0, 0), new(1, 0, 0), 2, By(way)); // t_ca is negative here
        RayAssert.Hits(way, SphereOf(default, 3), new(5, 0, 0), new(-1, 0, 0), 8, By(way), zNear: 5);
    }

    [Theory]
    [InlineData(Geometric)]
    [InlineData(Analytical)]
    public void ASphereBehindIsNotHit(string way) => RayAssert.Hits(way, SphereOf(default, 3), new(5, 0, 0), new(1, 0, 0), null, By(way));

    [Theory]
    [InlineData(Geometric)]
    [InlineData(Analytical)]
    public void RandomRays(string way)
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var C = chance.Point(5);
            RayAssert.Agrees(way, SphereOf(C, chance.Length()), chance.Point(), C + chance.Point(3), By(way));
        }
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(8, "sphere", "inside-sphere", "first", "near-plane", "mistakes/generic");
}
