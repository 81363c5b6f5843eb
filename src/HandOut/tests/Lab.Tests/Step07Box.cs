using Library = RayCaster;

namespace Lab.Tests;

/// <summary>Slides "AABB (Axis Aligned Bounding Box)", "AABB – intersection parameters", "AABB checking for intersection".</summary>
[Trait("step", "7")]
public class Step07Box : StepTests
{
    private const string SlabSlide = "AABB – intersection parameters";
    private const double Endless = double.PositiveInfinity;

    private static readonly (double B0, double B1, double P, double d, double t0, double t1)[] slabs =
    [
        (1, 3, 0, 1, 1, 3), // along the axis
        (1, 3, 5, -1, 2, 4), // against it: B1 comes first
        (1, 3, 2.5, 0.5, -3, 1), (1, 3, 5, 1, -4, -2), // from inside, behind
        (1, 3, 2, 0, -Endless, Endless), // parallel to the slab, all of the ray in it
        (1, 3, 1, 0, -Endless, Endless), (1, 3, 3, 0, -Endless, Endless), // on a face, where (B0 - P) / d is 0 / 0
        (1, 3, 0, 0, Endless, -Endless), (1, 3, 4, 0, Endless, -Endless), // parallel to it, outside
    ];

    /// <summary>While the intersection parameters are wrong, so is what is computed of them.</summary>
    private static string Slide => slabs.All(of => RayAssert.AreEqual(of.t0, Aabb.Slab(of.B0, of.B1, of.P, of.d).Item1)
        && RayAssert.AreEqual(of.t1, Aabb.Slab(of.B0, of.B1, of.P, of.d).Item2)) ? "AABB checking for intersection" : SlabSlide;

    private static readonly Library.Model box = BoxOf(new(-1, -2, -3), new(1, 2, 3));

    private readonly Chance chance = new();

    private static Library.Model BoxOf(Library.Vector3 B0, Library.Vector3 B1) => Library.Model.Of(new Library.Aabb(B0, B1));

    [Fact]
    public void TheIntersectionParameters()
    {
        foreach (var (B0, B1, P, d, t0, t1) in slabs)
        {
            var (first, second) = Aabb.Slab(B0, B1, P, d);
            var which = FormattableString.Invariant($"for B0 = {B0}, B1 = {B1}, P = {P}, d = {d}");
            RayAssert.Equal($"t0 {which}", SlabSlide, t0, first);
            RayAssert.Equal($"t1 {which}", SlabSlide, t1, second);
        }
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
    public void WhereZNearCutsOffTheNearSideTheFarSideShows() => RayAssert.Hits(Slide, box, new(5, 0, 0), new(-1, 0, 0), 6, zNear: 5);

    [Fact]
    public void ABoxBehindIsNotHit() => RayAssert.Hits(Slide, box, new(5, 0, 0), new(1, 0, 0), null);

    [Fact]
    public void ParallelToASlabOutsideOfItNothingIsHit()
    {
        RayAssert.Hits(Slide, box, new(5, 2.5, 0), new(-1, 0, 0), null);
        RayAssert.Hits(Slide, box, new(5, -2.5, 0), new(-1, 0, 0), null);
    }

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
    public void ThePictures() => PictureAssert.EqualAt(7, "aabb", "inside-box", "bias", "near-plane", "mistakes/axis");
}
