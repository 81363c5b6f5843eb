namespace RayCaster.Teaching.Tests.Visibility;

/// <summary>What maps say of a pixel is what the definition finds there.</summary>
public class MapMakerTests
{
    private static readonly Camera Camera = new(new(10, 0, 0), Vector3.Zero, fovY: 40, width: 31, height: 21);

    [Fact]
    public void TAndModelAreTheDefinitions()
    {
        foreach (var (hit, t) in Pixels(MapKind.T)) Assert.Equal((float)hit.T, t);
        foreach (var (hit, model) in Pixels(MapKind.Model)) Assert.Equal(hit.Model, model);
    }

    [Fact]
    public void DepthIsTheSameAllOverAWallAcrossTheView()
    {
        var map = MapMaker.Make(Scene(Model.Of(new Plane(new(-2, 0, 0), new(1, 0, 0)))), MapKind.Depth);
        Assert.All(map.Values, depth => Assert.Equal(12, depth, 1e-5));
    }

    [Theory]
    [InlineData(MapKind.T, float.PositiveInfinity)]
    [InlineData(MapKind.Depth, float.PositiveInfinity)]
    [InlineData(MapKind.Model, -1f)]
    public void WhereNothingIsHitThereIsAValueOfItsOwn(MapKind kind, float value) =>
        Assert.All(MapMaker.Make(Scene(), kind).Values, number => Assert.Equal(value, number));

    [Fact]
    public void ATBeyondTheRangeOfFloatsIsStillAHit()
    {
        var camera = new Camera(new(1e40, 0, 0), Vector3.Zero, width: 3, height: 3, zFar: 1e42);
        var map = MapMaker.Make(new Scene(camera, [Model.Of(new Plane(Vector3.Zero, new(1, 0, 0)))]), MapKind.T);
        Assert.All(map.Values, t => Assert.Equal(float.MaxValue, t));
    }

    [Fact]
    public void AMapThatDoesNotFitIsRefusedWithTheLimit()
    {
        var scene = Scene() with { Camera = Camera.With(width: 1_000_000, height: 10_000) };
        Assert.Contains($"{MapMaker.MaxPixels:N0}", Assert.Throws<ProblemException>(() => MapMaker.Make(scene, MapKind.T)).Message);
    }

    [Fact]
    public void InThePictureTheNearestIsTheBrightestAndNothingIsBlack()
    {
        var map = new NumberMap(3, 1);
        ReadOnlySpan<float> numbers = [1, 2, float.PositiveInfinity];
        numbers.CopyTo(map.Values);
        Assert.Equal([0xFD, 0xE7, 0x25, 0x44, 0x01, 0x54, 0, 0, 0], MapPicture.Draw(map, MapKind.Depth).Rgb);
    }

    [Fact]
    public void InThePictureModelsHaveColoursOfTheirOwn()
    {
        var map = new NumberMap(65, 1);
        for (var i = 0; i < 65; i++) map.Values[i] = i - 1;
        var picture = MapPicture.Draw(map, MapKind.Model);
        var colors = new HashSet<(byte, byte, byte)>();
        for (var i = 0; i < 65; i++) colors.Add(picture[i, 0]);
        Assert.Equal(65, colors.Count);
    }

    private static Scene Scene(params Model[] models) => new(Camera, models);

    private static IEnumerable<(Hit Hit, float Number)> Pixels(MapKind kind)
    {
        for (var seed = 0; seed < 16; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            var map = MapMaker.Make(scene, kind);
            for (var y = 0; y < map.Height; y++)
                for (var x = 0; x < map.Width; x++) yield return (ScalarRenderer.Cast(scene, x, map.Height - 1 - y), map[x, y]);
        }
    }
}
