namespace RayCaster.Teaching.Tests.Scenes;

/// <summary>What maps say of a pixel is what the definition finds there.</summary>
public class MapMakerTests
{
    private static readonly Camera Camera = new(new(10, 0, 0), Vector3.Zero, fovY: 40, width: 31, height: 21);

    [Fact]
    public void TAndModelAreTheDefinitions()
    {
        foreach (var (_, ray, t) in Pixels(MapKind.T)) Assert.Equal((float)ray.HitParameter, t[0]);
        foreach (var (scene, ray, model) in Pixels(MapKind.Model)) Assert.Equal(ray.HitModel, model[0] < 0 ? null : scene.Models[(int)model[0]]);
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
    [InlineData(MapKind.Normal, 0f)]
    [InlineData(MapKind.Uv, 0f)]
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
    public void NormalsAreOneLongAndFaceTheCamera()
    {
        foreach (var (_, ray, normal) in Pixels(MapKind.Normal).Where(pixel => pixel.Ray.HitModel is not null))
        {
            var n = new Vector3(normal[0], normal[1], normal[2]);
            Assert.Equal(1, n.Length, 1e-6);
            Assert.True(n * ray.Direction <= 1e-6, $"{n} looks away from the camera");
        }
    }

    [Fact]
    public void OfAMeshItIsTheNearestTrianglesNormal()
    {
        var triangles = 0;
        foreach (var (_, ray, normal) in Pixels(MapKind.Normal))
        {
            if (ray.HitModel is not Mesh mesh) continue;
            triangles++;
            var i = 0;
            while (mesh[i].Intersect(new Ray<Scalar>(ray.Origin, ray.Direction)).Near != ray.HitParameter) i++;
            var expected = ((mesh[i].B - mesh[i].A) % (mesh[i].C - mesh[i].A)).Normalized;
            Assert.Equal(1, Math.Abs(new Vector3(normal[0], normal[1], normal[2]) * expected), 1e-6);
        }
        Assert.InRange(triangles, 400, int.MaxValue);
    }

    [Fact]
    public void AShapeThatDoesNotKnowItsNormalGetsItFromItsNeighbours()
    {
        var scene = Scene(new Cylinder(Vector3.Zero, 2, 30));
        var map = MapMaker.Make(scene, MapKind.Normal);
        var ray = ScalarRenderer.Cast(scene, 18, 10);
        var X = ray.At(ray.HitParameter);
        var numbers = map[18, 10];
        Assert.Equal(X.X / 2, numbers[0], 1e-4);
        Assert.Equal(X.Y / 2, numbers[1], 1e-4);
        Assert.Equal(0, numbers[2], 1e-4);
    }

    public static TheoryData<string, double[], double[], double, double> Places => new()
    {
        { "sphere", [2, 0, 0], [1, 0, 0], 0.5, 0.5 },
        { "sphere", [0, 2, 0], [0, 1, 0], 0.75, 0.5 },
        { "sphere", [0, 0, 2], [0, 0, 1], 0.5, 1 },
        { "floor", [3, 4, 1], [0, 0, 1], 3, 4 },
        { "wall", [1, 3, 4], [1, 0, 0], 3, 4 },
        { "box", [1, 1, 1], [1, 0, 0], 0.5, 0.25 },
        { "box", [0.25, 0.5, 4], [0, 0, 1], 0.25, 0.25 },
        { "disc", [0, 1, 0], [0, 0, 1], 0.25, 0.5 },
        { "disc", [0, -2, 0], [0, 0, 1], 0.75, 1 },
        { "triangle", [1, 0, 0], [0, 0, 1], 0.25, 0 },
        { "triangle", [0, 1, 0], [0, 0, 1], 0, 0.5 },
    };

    [Theory]
    [MemberData(nameof(Places))]
    public void EachShapeKnowsItsSurface(string shape, double[] point, double[] normal, double u, double v)
    {
        Model model = shape switch
        {
            "sphere" => Model.Of(new Sphere(Vector3.Zero, 2)),
            "floor" => Model.Of(new Plane(new(0, 0, 1), new(0, 0, 1e-200))),
            "wall" => Model.Of(new Plane(new(1, 0, 0), new(5, 0, 0))),
            "box" => Model.Of(new Aabb(Vector3.Zero, new(1, 2, 4))),
            "disc" => Model.Of(new Circle(Vector3.Zero, new(0, 0, 3), 2)),
            _ => Model.Of(new Triangle(Vector3.Zero, new(4, 0, 0), new(0, 2, 0))),
        };
        var X = new Vector3(point[0], point[1], point[2]);
        Assert.Equal(0, (Surfaces.Normal(model, X)!.Value.Normalized - new Vector3(normal[0], normal[1], normal[2])).Length, 1e-12);
        Assert.Equal(u, Surfaces.Parameters(model, X).U, 1e-12);
        Assert.Equal(v, Surfaces.Parameters(model, X).V, 1e-12);
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
        var map = new NumberMap(3, 1, 1);
        ReadOnlySpan<float> numbers = [1, 2, float.PositiveInfinity];
        numbers.CopyTo(map.Values);
        Assert.Equal([0xFD, 0xE7, 0x25, 0x44, 0x01, 0x54, 0, 0, 0], MapPicture.Draw(map, MapKind.Depth).Rgb);
    }

    [Fact]
    public void InThePictureModelsHaveColoursOfTheirOwn()
    {
        var map = new NumberMap(65, 1, 1);
        for (var i = 0; i < 65; i++) map.Values[i] = i - 1;
        var picture = MapPicture.Draw(map, MapKind.Model);
        var colors = new HashSet<(byte, byte, byte)>();
        for (var i = 0; i < 65; i++) colors.Add(picture[i, 0]);
        Assert.Equal(65, colors.Count);
    }

    private static Scene Scene(params Model[] models) => new(Camera, models);

    private static IEnumerable<(Scene Scene, Ray Ray, float[] Numbers)> Pixels(MapKind kind)
    {
        for (var seed = 0; seed < 16; seed++)
        {
            var scene = RandomScene.Make(new Random(seed));
            var map = MapMaker.Make(scene, kind);
            for (var y = 0; y < map.Height; y++)
                for (var x = 0; x < map.Width; x++) yield return (scene, ScalarRenderer.Cast(scene, x, map.Height - 1 - y), map[x, y].ToArray());
        }
    }
}
