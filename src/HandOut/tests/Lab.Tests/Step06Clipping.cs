using System.Diagnostics;
using System.Globalization;
using RayCaster;

namespace Lab.Tests;

/// <summary>Slides "zNear &amp; zFar", "Bias".</summary>
[Trait("step", "6")]
public class Step06Clipping : StepTests
{
    private readonly Chance chance = new();

    [StackTraceHidden]
    private static void AssertCounts(
        bool expected, double t, double bias = 1e-6, double zNear = 0.01, double zFar = 100, double depthPerT = 1, string slide = "zNear & zFar")
    {
        var ray = new Ray(Vector3.Zero, new(1, 0, 0)) { Bias = bias, ZNear = zNear, ZFar = zFar, DepthPerT = depthPerT };
        Assert.True(ray.Counts(t) == expected, string.Create(CultureInfo.InvariantCulture,
            $"Counts({t:G6}): expected {expected}, but got {!expected}, for Bias = {bias:G6}, ZNear = {zNear:G6}, ZFar = {zFar:G6}, " +
            $"DepthPerT = {depthPerT:G6}, so z = {t * depthPerT:G6}.\n  {RayAssert.Cite(slide)}{Chance.Again}"));
    }

    [Fact]
    public void BothEndsCount()
    {
        AssertCounts(true, 3, zNear: 3, zFar: 7);
        AssertCounts(true, 7, zNear: 3, zFar: 7);
        AssertCounts(false, 2.9, zNear: 3, zFar: 7);
        AssertCounts(false, 7.1, zNear: 3, zFar: 7);
    }

    [Fact]
    public void TheyMeasureZNotT()
    {
        AssertCounts(true, 10, zFar: 6, depthPerT: 0.5); // z = 5
        AssertCounts(false, 4, zNear: 3, depthPerT: 0.5); // z = 2
    }

    [Fact]
    public void AHitIsBeyondTheBias()
    {
        AssertCounts(false, 1e-6, zNear: 0, slide: "Bias");
        AssertCounts(true, 2e-6, zNear: 0, slide: "Bias");
        AssertCounts(false, -1, zNear: -5, slide: "Bias");
    }

    [Fact]
    public void WithABiasOfZeroTheCameraMayTouch()
    {
        AssertCounts(true, 0, bias: 0, zNear: -1, slide: "Bias");
        AssertCounts(false, -1e-9, bias: 0, zNear: -1, slide: "Bias");
    }

    [Fact]
    public void NoNumberCounts() => AssertCounts(false, double.NaN);

    [Fact]
    public void RandomIntersections()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (t, bias, zNear, depthPerT) = (chance.Number(), chance.Length(1), chance.Length(), chance.Length(1));
            var zFar = zNear + chance.Length();
            AssertCounts(new ClipRange(bias, zNear, zFar).CountsMask<Scalar>(t, depthPerT) != 0, t, bias, zNear, zFar, depthPerT);
        }
    }

    [Fact]
    public void ThePictures() => PictureAssert.EqualAt(6, "clip-depth", "clip-distance", "far-plane", "near-plane");
}
