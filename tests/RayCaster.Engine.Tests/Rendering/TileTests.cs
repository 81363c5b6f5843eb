namespace RayCaster.Engine.Tests.Rendering;

/// <summary>The bounds of a model contain every pixel that hits it.</summary>
public class TileTests
{
    /// <summary>Boxes that begin exactly where a ray passes, in a picture so wide that the padding of their bounds is less than what the
    /// projection rounds.</summary>
    [Fact]
    public void WithoutItsMarginATileWouldLoseHitsAtTheEdgeOfABox()
    {
        var random = new Random(1);
        var (lost, lostWithoutMargin, hits) = (0, 0, 0);
        for (var i = 0; i < 3000; i++)
        {
            var width = random.Next(500_000, 1_000_000);
            var camera = new Camera(Vector3.Zero, new(-1, 0, 0), width: width, height: 1, zNear: 0, zFar: 1e9);
            var column = width / 2 + random.Next(1, 20);
            var edge = camera.PlaneWidth * column / width - camera.PlaneWidth / 2;
            var box = new Aabb(new(-1, edge, -1), new(-1, edge + 0.1, 1));
            if (ScalarRenderer.Cast(new Scene(camera, [Model.Of(box)]), column, 0).Model < 0) continue;
            hits++;
            var pixel = new PixelRect(column, 0, 1, 1);
            if (!new ScreenBounds(camera).TileOf(box.Bounds).Overlaps(pixel)) lost++;
            if (!InACrowd(box, camera).Overlaps(pixel)) lost++;
            if (!new ScreenBounds(camera, margin: double.Epsilon).TileOf(box.Bounds).Overlaps(pixel)) lostWithoutMargin++;
        }
        Assert.True(hits > 100, $"only {hits} hits");
        Assert.Equal(0, lost);
        Assert.NotEqual(0, lostWithoutMargin);
    }

    private static PixelRect InACrowd(Aabb box, Camera camera)
    {
        var bounds = new ScreenBounds(camera);
        bounds.Project<Packet>([box.Bounds]);
        return bounds.Read(0, out _, out _)!.Value;
    }
}
