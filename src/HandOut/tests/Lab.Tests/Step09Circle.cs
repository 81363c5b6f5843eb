using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slide "Circle".</summary>
[Trait("step", "9")]
public class Step09Circle : StepTests
{
    private const string Slide = "Circle";

    private readonly Chance chance = new();

    private static Library.Model CircleOf(Library.Vector3 C, Library.Vector3 n, double R) => Library.Model.Of(new Library.Circle(C, n, R));

    [Fact]
    public void OnlyUpToTheRadius()
    {
        var circle = CircleOf(default, new(1, 0, 0), 2);
        RayAssert.Hits(Slide, circle, new(5, 1.9, 0), new(-1, 0, 0), 5);
        RayAssert.Hits(Slide, circle, new(5, 2.1, 0), new(-1, 0, 0), null);
    }

    [Fact]
    public void TheRimBelongsToIt() => RayAssert.Hits(Slide, CircleOf(default, new(1, 0, 0), 2), new(5, 2, 0), new(-1, 0, 0), 5);

    [Fact]
    public void BothSidesAreSeenAndTheNormalMayHaveAnyLength()
    {
        RayAssert.Hits(Slide, CircleOf(default, new(-7, 0, 0), 2), new(5, 1, 0), new(-1, 0, 0), 5);
        RayAssert.Hits(Slide, CircleOf(default, new(-7, 0, 0), 2), new(-5, 1, 0), new(1, 0, 0), 5);
    }

    [Fact]
    public void AParallelRayHitsNothing()
    {
        RayAssert.Hits(Slide, CircleOf(default, new(0, 0, 1), 2), new(5, 0, 1), new(-1, 0, 0), null);
        RayAssert.Hits(Slide, CircleOf(default, new(0, 0, 1), 2), new(5, 0, 0), new(-1, 0, 0), null); // in its plane
    }

    [Fact]
    public void ACircleBehindIsNotHit() => RayAssert.Hits(Slide, CircleOf(default, new(1, 0, 0), 2), new(5, 0, 0), new(1, 0, 0), null);

    [Fact]
    public void RandomRays()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var C = chance.Point(5);
            RayAssert.Agrees(Slide, CircleOf(C, chance.Direction(), chance.Length()), chance.Point(), C + chance.Point(2));
        }
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(9, "circle", "tie", "background", "mistakes/generic");
}
