namespace RayCaster.Files.Tests.Frames;

public class CameraPathTests
{
    private static readonly Camera Scene = new(new(10, 0, 4), new(1, 2, 3), fovY: 40, width: 30, height: 20, zNear: 0.5, zFar: 90);

    [Fact]
    public void AnOrbitBeginsWithTheScenesOwnPicture() => Assert.Same(Scene, CameraMotion.Orbit(Scene, 0, 7));

    [Theory]
    [InlineData(1, 3, 11, 4)] // a quarter to the left, seen from the camera: counterclockwise from above
    [InlineData(2, -8, 4, 4)]
    [InlineData(3, -1, -7, 4)]
    public void AQuarterOfAnOrbitIsAQuarterTurnAboutTheTarget(int frame, double x, double y, double z)
    {
        var camera = CameraMotion.Orbit(Scene, frame, 4);
        AssertNear(new(x, y, z), camera.Position);
        Assert.Equal((Scene.Target, Scene.FovY, Scene.Width, Scene.ZFar), (camera.Target, camera.FovY, camera.Width, camera.ZFar));
    }

    [Fact]
    public void AnOrbitGoesAboutWhateverIsUp()
    {
        var scene = new Camera(new(0, 3, 5), Vector3.Zero, up: new(0, 7, 0));
        for (var frame = 0; frame < 9; frame++)
        {
            var camera = CameraMotion.Orbit(scene, frame, 9);
            Assert.Equal(3, camera.Position.Y, 12);
            Assert.Equal(Math.Sqrt(34), camera.Position.Length, 12);
        }
    }

    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void AWayPassesItsKeysToTheBit(bool isSmooth)
    {
        var path = new CameraPath(Keys, isSmooth);
        foreach (var key in Keys) Assert.Equal(key, path.At(key.Time));
        Assert.Equal(Keys[0].Position, path.Frame(Scene, 0, 8).Position);
        Assert.Equal(Keys[^1].Position, path.Frame(Scene, 7, 8).Position);
    }

    [Fact]
    public void AStraightWayIsEvenBetweenTwoKeys()
    {
        var key = new CameraPath(Keys, isSmooth: false).At(0.25);
        AssertNear(new(0.75, 0, 0), key.Position);
        AssertNear(new(1, 1, 0.25), key.Target);
        Assert.Equal(42.5, key.FovY, 12);
    }

    [Fact]
    public void ASmoothWayHasNoKnee()
    {
        var path = new CameraPath(Keys, isSmooth: true);
        var (before, behind) = ((path.At(1).Position - path.At(1 - 1e-6).Position) / 1e-6,
            (path.At(1 + 1e-6).Position - path.At(1).Position) / 1e-6);
        Assert.InRange((before - behind).Length, 0, 1e-4);
        AssertNear((Keys[2].Position - Keys[0].Position) / 3, before, 1e-4); // Catmull–Rom: as fast as from neighbour to neighbour
    }

    [Fact]
    public void ASmoothWayThroughKeysOnALineIsEven()
    {
        var path = new CameraPath(
            [new(0, new(1, 0, 0), default, 40), new(2, new(5, 0, 0), default, 40), new(3, new(7, 0, 0), default, 40)], isSmooth: true);
        for (var time = 0.0; time <= 3; time += 0.125) AssertNear(new(1 + 2 * time, 0, 0), path.At(time).Position);
    }

    [Fact]
    public void AFileLeavesOutWhatIsTheScenes()
    {
        var path = Read(
            """{ "keys": [ { "time": 0, "position": [9, 0, 0] }, """ +
            """{ "time": 2, "position": [0, 9, 0], "target": [0, 0, 1], "fovY": 60 }, ] } // both""",
            out var report)!;
        Assert.Empty(report);
        Assert.Equal(new(0, new(9, 0, 0), Scene.Target, Scene.FovY), path.At(0));
        Assert.Equal(new(2, new(0, 9, 0), new(0, 0, 1), 60), path.At(2));
    }

    [Theory]
    [InlineData("""{ "keys": [] }""", "keys must be at least two, but there is none")]
    [InlineData("""{ "keys": [ { "time": 0, "position": [9, 0, 0] } ] }""", "keys must be at least two, but there is one")]
    [InlineData("""{ "keys": [ { "time": 1, "position": [9, 0, 0] }, { "time": 1, "position": [8, 0, 0] } ] }""",
        "keys[1].time must be later than that of the key before, which is 1, but is 1")]
    [InlineData("""{ "keys": [ { "time": 0, "position": [1, 2, 3] }, { "time": 1, "position": [8, 0, 0] } ] }""",
        "keys[0].position must differ from the target, but both are [1, 2, 3]")]
    [InlineData("""{ "keys": [ { "time": 0, "position": [9, 0, 0], "fov": 3 }, { "time": 1, "position": [8, 0, 0] } ] }""",
        "keys[0].fov is an unknown key; did you mean \"fovY\"?")]
    [InlineData("""{ "interpolation": "curve", "keys": [] }""", "interpolation must be \"smooth\" or \"linear\", but is \"curve\"")]
    [InlineData("""[]""", "the camera's path must be an object in braces { }, but is ")]
    [InlineData("""{ "keys": """, "way.json(1,")]
    public void WhatIsWrongInAFileIsToldWithItsPlace(string json, string message)
    {
        Assert.Null(Read(json, out var report));
        Assert.StartsWith("way.json(1,", report);
        Assert.Contains(message, report);
    }

    [Fact]
    public void OfAKeyWhosePlacesAreWrongNothingElseIsSaid()
    {
        Assert.Null(Read("""{ "keys": [ { "time": 0, "position": "a", "target": "b" }, { "time": 1, "position": [8, 0, 0] } ] }""", out var report));
        Assert.Contains("keys[0].target must be an array", report);
        Assert.DoesNotContain("must differ", report);
    }

    [Fact]
    public void ALongFileIsReadUpToTheLimit()
    {
        using var folder = new TemporaryFolder();
        var path = folder.Write("way.json", new string(' ', ShortFile.MaxBytes + 1));
        Assert.Null(CameraPathReader.Read(path, Scene, out var report));
        Assert.Equal($"{path}: error: the file has more than 1,048,576 bytes, which is the limit\n", report);
    }

    [Theory]
    [InlineData(1, 2, 3, "the camera is at its target, [1, 2, 3]")]
    [InlineData(1, 2, 9, "the camera at [1, 2, 9] looks along up, which is [0, 0, 1]")]
    public void ACameraThatSeesNothingSaysWhy(double x, double y, double z, string flaw)
    {
        Assert.Null(Scene.ValidationError);
        Assert.Equal(flaw, (Scene.With(position: new(x, y, z))).ValidationError);
    }

    private static CameraKey[] Keys =>
        [new(0, Vector3.Zero, new(1, 1, 0), 40), new(1, new(3, 0, 0), new(1, 1, 1), 50), new(3, new(3, 6, 0), new(0, 1, 1), 45)];

    private static CameraPath? Read(string json, out string report)
    {
        using var folder = new TemporaryFolder();
        var path = CameraPathReader.Read(folder.Write("way.json", json), Scene, out report);
        report = report.Replace(folder.Path + Path.DirectorySeparatorChar, "");
        return path;
    }

    private static void AssertNear(Vector3 expected, Vector3 actual, double tolerance = 1e-12) =>
        Assert.True((expected - actual).Length <= tolerance, $"{expected} expected, but it is {actual}");
}
