namespace RayCaster.Engine.Tests.Rendering;

/// <summary>
/// Rays that lie in the plane of a triangle as well as doubles can tell: the weights of the corners are all noise, and the formula's t may be
/// that of any of them,
/// even where it is less than the distance of the triangle's box.
/// </summary>
public class EdgeOnTriangleTests
{
    [Theory]
    [InlineData(0)]
    [InlineData(100)] // behind the camera, so that the triangle is found as one of a crowd
    public void IsNotHiddenByWhatIsNearerThanItsBoxOnly(int companions)
    {
        var (random, found) = (new Random(5), 0);
        for (var i = 0; i < 40_000; i++)
        {
            var (d, across) = (Some.Direction(random), Some.Direction(random));
            var camera = new Camera(Vector3.Zero, d)
            {
                Up = Some.Direction(random),
                FovY = 1,
                Width = 1,
                Height = 1,
                Sample = PixelSample.Center,
                ZNear = 0,
            };
            d = camera.RayThrough(0, 0).Direction;
            var triangle = new Triangle(Corner(), Corner(), Corner());
            var t = ScalarRenderer.Cast(new Scene(camera, [Model.Of(triangle)]), 0, 0).T;
            var distance = Distance(triangle.Bounds);
            if (!(t < 0.999 * distance)) continue;

            found++;
            var between = Model.Of(new Sphere((0.5 * (t + distance) + 10) * d, 10));
            var scene = new Scene(camera,
                [between, between, between, between, between, Model.Of(triangle),
                    .. Enumerable.Repeat(Model.Of(new Sphere(-10 * d, 1)), companions)]);
            Assert.Equal(ScalarRenderer.Cast(scene, 0, 0).T, new Renderer(scene, threads: 1).CastHits().T[0]);

            Vector3 Corner() => (1 + 4 * random.NextDouble()) * d + 4 * (random.NextDouble() - 0.5) * across;
        }
        Assert.InRange(found, 10, 40_000);
    }

    private static double Distance(Bounds bounds) => new Vector3(
        Math.Max(0, Math.Max(bounds.Min.X, -bounds.Max.X)),
        Math.Max(0, Math.Max(bounds.Min.Y, -bounds.Max.Y)),
        Math.Max(0, Math.Max(bounds.Min.Z, -bounds.Max.Z))).Length;
}
