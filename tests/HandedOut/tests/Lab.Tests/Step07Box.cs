using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slides "AABB (Axis Aligned Bounding Box)", "AABB – intersection parameters", "AABB checking for intersection".</summary>
[Trait("step", "7")]
public class Step07Box : StepTests
{
    private const string SlabSlide = "AABB – intersection parameters";

    /// <summary>While the intersection parameters are wrong, so is what is computed of them.</summary>
    private static string Slide =>
        Aabb.Slab(1, 3, 0, 0.5) == (2, 6) && Aabb.Slab(1, 3, 5, -1) == (2, 4) ? "AABB checking for intersection" : SlabSlide;

    private static readonly Library.Model box = BoxOf(new(-1, -2, -3), new(1, 2, 3));

    private readonly Chance chance = new();

    private static Library.Model BoxOf(Library.Vector3 B0, Library.Vector3 B1) => Library.Model.Of(new Library.Aabb(B0, B1));

    [Theory]
    [InlineData(1, 3, 0, 1, 1, 3)] // along the axis
    [InlineData(1, 3, 5, -1, 2, 4)] // against it: B1 comes first
    [InlineData(1, 3, 2, 0.5, -2, 2)] // from inside
    [InlineData(1, 3, 2, 0, double.NegativeInfinity, double.PositiveInfinity)] // parallel to the slab, all of the ray in it
    [InlineData(1, 3, 1, 0, double.NegativeInfinity, double.PositiveInfinity)] // on its face, where (B0 - P) / d is 0 / 0
    public void TheIntersectionParameters(double B0, double B1, double P, double d, double t0, double t1)
    {
        var (first, second) = Aabb.Slab(B0, B1, P, d);
        var which = FormattableString.Invariant($"for B0 = {B0}, B1 = {B1}, P = {P}, d = {d}");
        Assert.True(Same(first, t0), FormattableString.Invariant($"t0 {which}: expected {t0}, but got {first}.\n  {RayAssert.Cite(SlabSlide)}"));
        Assert.True(Same(second, t1), FormattableString.Invariant($"t1 {which}: expected {t1}, but got {second}.\n  {RayAssert.Cite(SlabSlide)}"));

        static bool Same(double a, double b) => a == b || Math.Abs(a - b) < 1e-9;
    }

    [Fact]
    public void AlongEachAxisFromEachSide()
    {
        foreach (var (axis, half) in ((Library.Vector3, double)[])[(new(1, 0, 0), 1), (new(0, 1, 0), 2), (new(0, 0, 1), 3)])
            foreach (var side in (double[])[-1, 1])
                RayAssert.Hits(Slide, box, 10 * side * axis, -side * axis, 10 - half);
    }

    [Fact]
    public void FromInsideTheFarSideShows() => RayAssert.Hits(Slide, box, default, new(0, 1, 0), 2);

    [Fact]
    public void ABoxBehindIsNotHit() => RayAssert.Hits(Slide, box, new(5, 0, 0), new(1, 0, 0), null);

    [Fact]
    public void ParallelToASlabOutsideOfItNothingIsHit() => RayAssert.Hits(Slide, box, new(5, 2.5, 0), new(-1, 0, 0), null);

    [Fact]
    public void ARayInAFaceHitsForTheFaceBelongsToTheBox() => RayAssert.Hits(Slide, box, new(5, 2, 0), new(-1, 0, 0), 4);

    [Fact]
    public void AFlatBoxIsHit() => RayAssert.Hits(Slide, BoxOf(new(-1, -1, 0), new(1, 1, 0)), new(0, 0, 4), new(0, 0, -1), 4);

    [Fact]
    public void RandomRays()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (B0, size) = (chance.Point(5), new Library.Vector3(chance.Length(), chance.Length(), chance.Length()));
            RayAssert.Agrees(Slide, BoxOf(B0, B0 + size), chance.Point(), B0 + size / 2 + chance.Point(2));
        }
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(7, "aabb", "inside-box", "bias", "mistakes/axis");
}
