namespace RayCaster.Files.Tests.Scenes;

public class CameraMotionTests
{
    private static readonly Camera Scene = new(new(10, 0, 4), new(1, 2, 3)) { FovY = 40, Width = 30, Height = 20, ZNear = 0.5, ZFar = 90 };

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
        var scene = new Camera(new(0, 3, 5), Vector3.Zero) { Up = new(0, 7, 0) };
        for (var frame = 0; frame < 9; frame++)
        {
            var camera = CameraMotion.Orbit(scene, frame, 9);
            Assert.Equal(3, camera.Position.Y, 12);
            Assert.Equal(Math.Sqrt(34), camera.Position.Length, 12);
        }
    }

    [Theory]
    [InlineData(1, 2, 3, "target must differ from position, but both are [1, 2, 3]")]
    [InlineData(1, 2, 9, "up must not be parallel to target - position, but is [0, 0, 1]")]
    public void ACameraThatSeesNothingSaysWhy(double x, double y, double z, string flaw)
    {
        Assert.Null(Scene.ValidationError);
        Assert.Equal(flaw, (Scene with { Position = new(x, y, z) }).ValidationError);
    }

    private static void AssertNear(Vector3 expected, Vector3 actual, double tolerance = 1e-12) =>
        Assert.True((expected - actual).Length <= tolerance, $"{expected} expected, but it is {actual}");
}
