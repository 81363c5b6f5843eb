namespace RayCaster.Tests.Slides;

/// <summary>The slides' own lines of code compile against the library and mean what the slides say.</summary>
public class SlideTests
{
    private readonly Vector3 P = new(20, 0, 0);
    private readonly Vector3 Position = new(20, 0, 0);
    private readonly Vector3 Target = Vector3.Zero;

    [Fact]
    public void SlideVectorsPointMinusZeroIsThePoint()
    {
        Vector3 Q = P - Vector3.Zero;
        Assert.Equal(P, Q);
    }

    [Fact]
    public void SlideVectorsLengthsOfAListAddUp()
    {
        var path = new List<Vector3> { new(3, 4, 0), new(0, 0, 2) };
        double length = 0;
        foreach (var v in path) length += v.Length;
        Assert.Equal(7, length);
    }

    [Fact]
    public void SlideVectorsANumberMultipliesFromEitherSide()
    {
        var v = new Vector3(1, -2, 3);
        Assert.Equal(new Vector3(2, -4, 6), 2.0 * v);
        Assert.Equal(2.0 * v, v * 2.0);
    }

    [Fact]
    public void SlideDotProductIsWrittenAsAProduct()
    {
        Vector3 a = new(1, 2, 3), b = new(4, -5, 6);
        Assert.Equal(12, a * b);
    }

    [Fact]
    public void SlideCrossProductIsWrittenAsARemainder()
    {
        Vector3 a = new(1, 0, 0), b = new(0, 1, 0);
        Assert.Equal(new Vector3(0, 0, 1), a % b);
    }

    [Fact]
    public void SlideRayThroughAPixelMakesADirectionOfLengthOne()
    {
        var camera = new Camera(Position, Target);
        var (U, V, W) = (camera.U, camera.V, camera.W);
        var (uc, ur) = (-0.25, 0.125);
        var d = (uc * U + ur * V - W).Normalized;
        Assert.Equal(1, d.Length, 15);
        Assert.Equal(new Vector3(-1, -0.25, 0.125).Normalized, d);
    }

    [Fact]
    public void SlideAttenuationHalvesTheColourAtTheTarget()
    {
        var camera = new Camera(Position, Target) { Sample = PixelSample.Center, Width = 1, Height = 1 };
        var scene = new Scene(camera, [Model.Of(new Plane(Target, new(1, 0, 0)))]);
        var hit = ScalarRenderer.Cast(scene, 0, 0);
        var attenuation = 1 - hit.T / (2 * (Target - Position)).Length;
        Assert.Equal(0.5, attenuation);
        Assert.Equal(new Color(0.5, 0.5, 0.5), attenuation * scene.Models[hit.Model].Color);
    }
}
