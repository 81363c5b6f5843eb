namespace RayCaster.Tests.Shapes;

public class TriangleTests
{
    private static readonly Vector3 A = new(0, 0, 2), B = new(4, 0, 2), C = new(0, 4, 2);

    public static TheoryData<Triangle> Windings =>
    [
        new Triangle(A, B, C), new Triangle(B, C, A), new Triangle(C, A, B), new Triangle(A, C, B), new Triangle(C, B, A), new Triangle(B, A, C),
    ];

    [Theory]
    [MemberData(nameof(Windings))]
    public void TheInsideIsHitFromBothSides(Triangle triangle)
    {
        RayAssert.Hits(triangle, new(1, 1, 10), new(0, 0, -1), 8);
        RayAssert.Hits(triangle, new(1, 1, -10), new(0, 0, 1), 12);
    }

    [Theory]
    [MemberData(nameof(Windings))]
    public void CornersAndEdgesBelongToIt(Triangle triangle)
    {
        foreach (var point in new[] { A, B, C, new(2, 0, 2), new(0, 3, 2), new(1, 3, 2) })
            RayAssert.Hits(triangle, point + new Vector3(0, 0, 8), new(0, 0, -1), 8);
    }

    [Theory]
    [MemberData(nameof(Windings))]
    public void JustOutsideAnEdgeIsNoHit(Triangle triangle)
    {
        foreach (var point in new[] { new Vector3(-1e-300, 1, 10), new(1, -1e-300, 10), new(2, Math.BitIncrement(2), 10) })
            RayAssert.Hits(triangle, point, new(0, 0, -1), null);
    }

    [Theory]
    [MemberData(nameof(Windings))]
    public void ARayInItsPlaneDoesNotHit(Triangle triangle) => RayAssert.Hits(triangle, new(-1, 1, 2), new(1, 0, 0), null);

    [Fact]
    public void BehindTheOriginIsNoHit() => RayAssert.Hits(new Triangle(A, B, C), new(1, 1, 10), new(0, 0, 1), null);

    /// <summary>u and v by Cramer's rule, as on the slide "Triangle".</summary>
    [Fact]
    public void TheBarycentricCoordinatesOfTheSlideAgree()
    {
        var random = new Random(3);
        var (inside, outside) = (0, 0);
        for (var i = 0; i < 20_000; i++)
        {
            var (a, b, c) = (Some.Point(random, 5), Some.Point(random, 5), Some.Point(random, 5));
            var (origin, d) = (Some.Point(random, 5), Some.Direction(random));
            var (e1, e2, s) = (b - a, c - a, origin - a);
            var determinant = d % e2 * e1;
            if (Math.Abs(determinant) < 0.1) continue; // seen along its edge
            var (u, v, t) = (d % e2 * s / determinant, s % e1 * d / determinant, s % e1 * e2 / determinant);
            var least = Math.Min(Math.Min(u, v), 1 - u - v);
            if (Math.Abs(least) < 1e-9) continue;      // on its outline

            RayAssert.Crosses(new Triangle(a, b, c), origin, d, least < 0 ? double.NaN : t, double.NaN, 1e-10);
            if (least < 0) outside++;
            else inside++;
        }
        Assert.True(inside > 500 && outside > 500);
    }

    /// <summary>All three corners lie up and to the right of the ray, on a line with it except in the last bits.</summary>
    [Fact]
    public void ATriangleSeenEdgeOnIsNotHitByRaysThatOnlyPassWithinItsPlane()
    {
        var triangle = new Triangle(new(0, 0, -2), new(-0.2, -0.2, -2.1), new(0.30000000000000004, 0.2, -1.9));
        var camera = new Camera(new(-1, 2, -1), new(0, 2, -1)) { FovY = 90, Width = 23, Height = 16, Sample = PixelSample.Center };
        RayAssert.HitsAlong(triangle, camera.RayThrough(4, 11), null);
    }
}
