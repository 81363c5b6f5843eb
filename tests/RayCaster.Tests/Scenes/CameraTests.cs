namespace RayCaster.Tests.Scenes;

public class CameraTests
{
    private static readonly Camera course = new(new(20, 0, 0), new(0, 0, 0));

    private static void AssertNear(Vector3 expected, Vector3 actual) =>
        Assert.True((expected - actual).Length <= 1e-14, $"expected {expected}, got {actual}");

    [Fact]
    public void WLooksBackwards() => Assert.Equal(new Vector3(1, 0, 0), course.W);

    [Fact]
    public void UPointsToTheRight() => Assert.Equal(new Vector3(0, 1, 0), course.U);

    [Fact]
    public void VPointsUpwards() => Assert.Equal(new Vector3(0, 0, 1), course.V);

    [Fact]
    public void ATiltedCameraHasAxesOfLength1ThatAreRightHandedAndAcrossEachOther()
    {
        var camera = new Camera(new(3, -4, 12), new(1, 1, 1)) { Up = new(0.3, 0.2, 7) };
        AssertNear(new Vector3(2, -5, 11) / Math.Sqrt(150), camera.W);
        Assert.Equal(1, camera.U.Length, 1e-15);
        Assert.Equal(0, camera.U * camera.W, 1e-15);
        Assert.Equal(0, camera.U * camera.Up, 1e-15); // to the right means level with respect to up
        AssertNear(camera.V, camera.W % camera.U);
        Assert.True(camera.V * camera.Up > 0);
    }

    [Theory]
    [InlineData(90, 2)]
    [InlineData(45, 0.82842712474619009760)] // 2 (√2 − 1)
    [InlineData(60, 1.15470053837925152902)] // 2 / √3
    [InlineData(120, 3.46410161513775458705)] // 2 √3
    public void ThePlaneIsTwoTangentsOfTheHalfAngleHigh(double fovY, double height) =>
        Assert.Equal(height, new Camera(default, new(1, 0, 0)) { FovY = fovY }.PlaneHeight, 1e-14);

    [Fact]
    public void ThePlaneHasTheShapeOfThePicture()
    {
        var camera = new Camera(default, new(1, 0, 0)) { FovY = 90, Width = 300, Height = 200 };
        Assert.Equal(3, camera.PlaneWidth, 1e-14);
    }

    /// <summary>With fovY 90 and 4 × 2 pixels a pixel is 1 wide and high, and the plane reaches from (−2, −1) to (2, 1).</summary>
    [Theory]
    [InlineData(PixelSample.Corner, 0, 0, -2, -1)]
    [InlineData(PixelSample.Corner, 2, 1, 0, 0)]
    [InlineData(PixelSample.Corner, 3, 1, 1, 0)]
    [InlineData(PixelSample.Center, 0, 0, -1.5, -0.5)]
    [InlineData(PixelSample.Center, 3, 1, 1.5, 0.5)]
    public void ARayPassesThroughItsPixelInThePicturePlane(PixelSample sample, int column, int row, double uc, double ur)
    {
        var camera = new Camera(new(7, 8, 9), new(6, 8, 9)) { FovY = 90, Width = 4, Height = 2, Sample = sample };
        var ray = camera.RayThrough(column, row);
        AssertNear(new Vector3(-1, uc, ur).Normalized, ray.Direction);
        Assert.Equal(camera.Position, ray.Origin);
    }

    [Theory]
    [InlineData(ClipMode.Depth, 0.6)]
    [InlineData(ClipMode.Distance, 1)]
    public void WhatZGainsAlongTheRayDependsOnTheKindOfClipping(ClipMode clip, double depthPerT)
    {
        var camera = new Camera(default, new(-1, 0, 0)) { FovY = 2 * Math.Atan(4.0 / 3) * 180 / Math.PI, Width = 2, Height = 2, Clip = clip };
        Assert.Equal(depthPerT, camera.RayThrough(1, 0).DepthPerT, 1e-14); // the lower edge's middle: 3-4-5
    }

    [Fact]
    public void AChangedCameraIsThatOfTheChangedSettings()
    {
        var camera = Other(new(1, 2, 3), 50) with { Width = 7, FovY = 60, Position = new(3, 2, 1) };
        Assert.Equal(Other(new(3, 2, 1), 60) with { Width = 7 }, camera);
        Assert.Equal((7, 20, 60), (camera.Width, camera.Height, camera.FovY));
        Assert.Equal(camera.PlaneHeight * 7 / 20, camera.PlaneWidth);
        Assert.Equal((new(4, 5, 7), new(1, 0, 0), 0.5, 60, 0.25, ClipMode.Distance, PixelSample.Center),
            (camera.Target, camera.Up, camera.ZNear, camera.ZFar, camera.Bias, camera.Clip, camera.Sample));

        static Camera Other(Vector3 position, double fovY) => new(position, new(4, 5, 7))
        {
            Up = new(1, 0, 0),
            FovY = fovY,
            Width = 10,
            Height = 20,
            ZNear = 0.5,
            ZFar = 60,
            Bias = 0.25,
            Clip = ClipMode.Distance,
            Sample = PixelSample.Center,
        };
    }
}
