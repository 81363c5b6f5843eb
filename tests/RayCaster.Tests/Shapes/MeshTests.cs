namespace RayCaster.Tests.Shapes;

public class MeshTests
{
    /// <summary>Two parallel squares' halves, the farther one first in the file.</summary>
    private static readonly Mesh mesh = new(
        [new(0, 0, 1), new(4, 0, 1), new(0, 4, 1), new(0, 0, 3), new(4, 0, 3), new(0, 4, 3)], [0, 1, 2, 3, 5, 4]);

    private static double? At(Vector3 origin, Vector3 direction) => mesh.Intersect(new Ray(origin, direction.Normalized));

    [Fact]
    public void TheNearestTriangleIsHit() => Assert.Equal((2, 1), (At(new(1, 1, 5), new(0, 0, -1)), At(new(1, 1, 0), new(0, 0, 1))));

    [Fact]
    public void WhatIsBehindTheOriginDoesNotHideWhatIsInFront() => Assert.Equal(1, At(new(1, 1, 2), new(0, 0, -1)));

    [Fact]
    public void ATriangleThatIsClippedAwayShowsTheOneBehind()
    {
        var ray = new Ray(new(1, 1, 5), new(0, 0, -1)) { ClipRange = new ClipRange(0, 3, 100) };
        Assert.Equal(4, mesh.Intersect(ray));
    }

    [Fact]
    public void ARayThatPassesByHasNoHit() => Assert.Null(At(new(3, 3, 5), new(0, 0, -1)));

    [Fact]
    public void AMeshIsTheTrianglesThatItIsMadeOf()
    {
        var random = new Random(4);
        var solid = Solids.Icosphere(1);
        for (var i = 0; i < 2000; i++)
        {
            var ray = new Ray(Some.Point(random, 2), Some.Direction(random));
            Assert.Equal(Enumerable.Range(0, solid.TriangleCount).Min(t => Model.Of(solid[t]).Intersect(ray)), solid.Intersect(ray));
        }
    }
}
