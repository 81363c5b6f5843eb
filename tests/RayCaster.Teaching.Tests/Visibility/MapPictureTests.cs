namespace RayCaster.Teaching.Tests.Visibility;

/// <summary>What maps show of a pixel is what the definition finds there.</summary>
public class MapPictureTests
{
    private static readonly Camera Camera = new(new(10, 0, 0), Vector3.Zero) { FovY = 40, Width = 31, Height = 21 };

    [Fact]
    public void PixelsOfOneModelHaveOneColourAndNothingIsBlack()
    {
        for (var seed = 0; seed < 16; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            var map = MapPicture.Draw(scene, MapKind.Model);
            foreach (var (x, y, hit) in Hits(scene)) Assert.Equal(hit.Model < 0 ? default : map.Legend[hit.Model], map.Picture[x, y]);
            Assert.Equal(map.Legend.Count, map.Legend.Distinct().Count());
        }
    }

    [Fact]
    public void TheRangeOfTIsTheDefinitions()
    {
        for (var seed = 0; seed < 16; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            double[] t = [.. Hits(scene).Where(pixel => pixel.Hit.Model >= 0).Select(pixel => pixel.Hit.T)];
            Assert.Equal(t.Length == 0 ? null : (t.Min(), t.Max()), MapPicture.Draw(scene, MapKind.T).Range);
        }
    }

    [Fact]
    public void TheNearestIsTheBrightest()
    {
        var map = MapPicture.Draw(Scene(Model.Of(new Plane(new(0, 0, -1), new(0, 0, 1)))), MapKind.T);
        Assert.Equal(((byte)0xFD, (byte)0xE7, (byte)0x25), map.Legend[0]);
        Assert.Equal(((byte)0x44, (byte)0x01, (byte)0x54), map.Legend[^1]);
        Assert.Equal(map.Legend[0], map.Picture[15, 20]);
        Assert.Equal(default, map.Picture[15, 0]);
    }

    [Fact]
    public void DepthIsTheSameAllOverAWallAcrossTheView()
    {
        var (least, greatest) = MapPicture.Draw(Scene(Model.Of(new Plane(new(-2, 0, 0), new(1, 0, 0)))), MapKind.Depth).Range!.Value;
        Assert.Equal((12, 12), (least, greatest), (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 1e-12);
    }

    [Fact]
    public void WithoutAHitThereIsNoRange() => Assert.Null(MapPicture.Draw(Scene(), MapKind.T).Range);

    [Fact]
    public void AMapThatDoesNotFitIsRefusedWithTheLimit()
    {
        var scene = Scene() with { Camera = Camera with { Width = 1_000_000, Height = 10_000 } };
        Assert.Contains($"{MapPicture.MaxPixels:N0}", Assert.Throws<ProblemException>(() => MapPicture.Draw(scene, MapKind.T)).Message);
    }

    private static Scene Scene(params Model[] models) => new(Camera, models);

    private static IEnumerable<(int X, int Y, Hit Hit)> Hits(Scene scene)
    {
        for (var y = 0; y < scene.Camera.Height; y++)
            for (var x = 0; x < scene.Camera.Width; x++) yield return (x, y, ScalarRenderer.Cast(scene, x, scene.Camera.Height - 1 - y));
    }
}
