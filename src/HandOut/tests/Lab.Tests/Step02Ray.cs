using System.Diagnostics;

namespace Lab.Tests;

/// <summary>Slide "Ray".</summary>
[Trait("step", "2")]
public class Step02Ray : StepTests
{
    private const string Slide = "Ray";

    private readonly Chance chance = new();

    private readonly Ray ray = new(new(20, 0, 0), new(-1, 0, 0));

    private readonly Model near = new Plane(Vector3.Zero, new(1, 0, 0)), far = new Plane(new(-5, 0, 0), new(1, 0, 0));

    [Fact]
    public void TheSlidesNumbers() => RayAssert.Equal("X(25) for P = (20, 0, 0), d = (-1, 0, 0)", Slide, new(-5, 0, 0), ray.At(25));

    [Fact]
    public void TheNearestHitStaysWhicheverComesFirst()
    {
        ray.Hit(25, far);
        AssertHit(25, far, "after a hit at 25");
        ray.Hit(20, near);
        AssertHit(20, near, "after hits at 25 and 20");
        ray.Hit(22, far);
        AssertHit(20, near, "after hits at 25, 20 and 22");
    }

    [Fact]
    public void OfTwoHitsAtTheSameTTheFirstStays()
    {
        ray.Hit(20, near);
        ray.Hit(20, far);
        AssertHit(20, near, "after two hits at 20, of which the first stays");
    }

    [Fact]
    public void WhatIsBehindOrNoNumberIsNoHit()
    {
        ray.Hit(-3, near);
        ray.Hit(double.NaN, near);
        var got = double.IsPositiveInfinity(ray.HitParameter)
            ? "HitModel is set, though HitParameter is not: an `if` without braces holds for one line only"
            : $"got t = {ray.HitParameter}: call Counts(t), and store only a t that counts";
        Assert.True(ray.HitModel == null, $"after t = -3 and t = NaN there is no hit, but {got}.\n  {RayAssert.Cite(Slide)}");
        ray.Hit(20, near);
        AssertHit(20, near, "after t = -3, t = NaN and a hit at 20");
    }

    [Fact]
    public void RandomPoints()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (P, d, t) = (chance.Point(), chance.Direction().Normalized, chance.Number());
            var random = new Ray(RayAssert.Mine(P), RayAssert.Mine(d));
            var untouched = new Untouched(("this", random));
            var actual = random.At(t);
            untouched.Check(Slide);
            RayAssert.Equal($"X({RayAssert.Text(t)}) for P = {RayAssert.Text(P)}, d = {RayAssert.Text(d)}", Slide, P + t * d, actual);
        }
    }

    [StackTraceHidden]
    private void AssertHit(double t, Model model, string when)
    {
        Assert.True(ray.Counts(t), $"Counts({t}) of a ray that is not clipped: expected True, but got False.\n  {RayAssert.Cite("zNear & zFar")}");
        RayAssert.Equal($"HitParameter {when}", Slide, t, ray.HitParameter);
        var got = ray.HitModel == null ? "null" : "the model of another hit";
        Assert.True(ray.HitModel == model, $"HitModel {when}: expected the model of the hit at {t}, but got {got}.\n  {RayAssert.Cite(Slide)}");
    }
}
