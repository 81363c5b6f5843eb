using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slides "Sphere", "Sphere – Geometric Solution", "Sphere – Analytical Solution": both ways lead to the same intersections.</summary>
[Trait("step", "8")]
public class Step08Sphere : StepTests
{
    private readonly Chance chance = new();

    public static TheoryData<string> Ways => ["Sphere – Geometric Solution", "Sphere – Analytical Solution"];

    private static Library.Model SphereOf(Library.Vector3 C, double R) => Library.Model.Of(new Library.Sphere(C, R));

    private static Action<Model, Ray> By(string way) =>
        way.Contains("Analytical") ? (sphere, ray) => ((Sphere)sphere).AnalyticalSolution(ray)
            : (sphere, ray) => ((Sphere)sphere).GeometricSolution(ray);

    [Theory]
    [MemberData(nameof(Ways))]
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
        const string way = "Sphere – Analytical Solution";
        RayAssert.Hits(way, SphereOf(default, 4), new(20, 0, 0), new(-2, 0, 0), 8, By(way));
    }

    [Theory]
    [MemberData(nameof(Ways))]
    public void RandomRays(string way)
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var C = chance.Point(5);
            RayAssert.Agrees(way, SphereOf(C, chance.Length()), chance.Point(), C + chance.Point(3), By(way));
        }
    }

    [Theory]
    [MemberData(nameof(Ways))]
    public void ARayThatPassesByHitsNothing(string way) => RayAssert.Hits(way, SphereOf(default, 1), new(5, 1.1, 0), new(-1, 0, 0), null, By(way));

    [Theory]
    [MemberData(nameof(Ways))]
    public void FromInsideTheFarSideShowsAlsoWhereTheCentreIsBehind(string way)
    {
        RayAssert.Hits(way, SphereOf(default, 3), new(1, 0, 0), new(-1, 0, 0), 4, By(way));
        RayAssert.Hits(way, SphereOf(default, 3), new(1, 0, 0), new(1, 0, 0), 2, By(way)); // t_ca is negative here
    }

    [Theory]
    [MemberData(nameof(Ways))]
    public void ASphereBehindIsNotHit(string way) => RayAssert.Hits(way, SphereOf(default, 3), new(5, 0, 0), new(1, 0, 0), null, By(way));

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(8, "sphere", "inside-sphere", "first", "mistakes/generic");
}
