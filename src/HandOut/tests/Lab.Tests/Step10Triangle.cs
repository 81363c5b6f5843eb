using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slide "Triangle".</summary>
[Trait("step", "10")]
public class Step10Triangle : StepTests
{
    private const string Slide = "Triangle";

    private static readonly Library.Model triangle = TriangleOf(new(0, 0, 0), new(0, 4, 0), new(0, 0, 4));

    private readonly Chance chance = new();

    private static Library.Model TriangleOf(Library.Vector3 A, Library.Vector3 B, Library.Vector3 C) =>
        Library.Model.Of(new Library.Triangle(A, B, C));

    [Theory]
    [InlineData(1, 1, true)]
    [InlineData(-0.1, 1, false)] // u < 0 or v < 0
    [InlineData(1, -0.1, false)]
    [InlineData(2.1, 2.1, false)] // u + v > 1
    public void InsideAndOutside(double y, double z, bool isHit) =>
        RayAssert.Hits(Slide, triangle, new(5, y, z), new(-1, 0, 0), isHit ? 5 : null);

    [Fact]
    public void BothWindingsAreSeenFromBothSides()
    {
        var turned = TriangleOf(new(0, 0, 0), new(0, 0, 4), new(0, 4, 0));
        foreach (var model in (Library.Model[])[triangle, turned])
        {
            RayAssert.Hits(Slide, model, new(5, 1, 1), new(-1, 0, 0), 5);
            RayAssert.Hits(Slide, model, new(-5, 1, 1), new(1, 0, 0), 5);
        }
    }

    /// <summary>The slide's strict u &gt; 0 would leave cracks between triangles that share an edge.</summary>
    [Fact]
    public void EdgesBelongToTheTriangle()
    {
        RayAssert.Hits(Slide, triangle, new(5, 1, 0), new(-1, 0, 0), 5);
        RayAssert.Hits(Slide, triangle, new(5, 0, 1), new(-1, 0, 0), 5);
        RayAssert.Hits(Slide, triangle, new(5, 2, 2), new(-1, 0, 0), 5);
    }

    [Fact]
    public void AParallelRayHitsNothing()
    {
        RayAssert.Hits(Slide, triangle, new(1, -1, 1), new(0, 1, 0), null);
        RayAssert.Hits(Slide, triangle, new(0, -1, 1), new(0, 1, 0), null); // in its plane
    }

    [Fact]
    public void ATriangleBehindIsNotHit() => RayAssert.Hits(Slide, triangle, new(5, 1, 1), new(1, 0, 0), null);

    [Fact]
    public void RandomRays()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (A, B, C) = (chance.Point(4), chance.Point(4), chance.Point(4));
            var (u, v) = (chance.Number(1.2), chance.Number(1.2));
            RayAssert.Agrees(Slide, TriangleOf(A, B, C), chance.Point(), (1 - u - v) * A + u * B + v * C);
        }
    }

    [Fact]
    public void ThePictures() =>
        PictureAssert.EqualAt(10, "triangle", "windings", "room", "mistakes/portrait", "mistakes/inside", "mistakes/generic");
}
