using Xunit.Sdk;

namespace Lab.Tests;

/// <summary>What a failed test of a step says of code that gives the right t for the wrong reason, or nearly the right t.</summary>
public class RayAssertTests
{
    private const string Slide = "Ray – Plane Intersection";

    private static readonly RayCaster.Model plane = RayCaster.Model.Of(new RayCaster.Plane(default, new(1, 0, 0)));

    /// <summary>The message for a ray from (3, 0, 0) to a plane at t = 3; empty if the test passes.</summary>
    private static string Said(Action<Model, Ray> intersect)
    {
        try
        {
            RayAssert.Hits(Slide, plane, new(3, 0, 0), new(-1, 0, 0), 3, intersect);
            return "";
        }
        catch (FailException failure)
        {
            return failure.Message.Split('\n')[0];
        }
    }

    [Fact]
    public void ARightHitPasses() => Assert.Equal("", Said((model, ray) => ray.Hit(3, model)));

    [Fact]
    public void AChangedRayIsTold() => Assert.Equal("the call has changed ray.Origin.X from 3 to -3.", Said((model, ray) =>
    {
        var L = ray.Origin;
        L.X = -L.X;
        ray.Hit(3, model);
    }));

    [Fact]
    public void AChangedModelIsTold() => Assert.Equal("the call has changed this.n.X from 1 to 2.", Said((model, ray) =>
    {
        ((Plane)model).n = new(2, 0, 0);
        ray.Hit(3, model);
    }));

    [Fact]
    public void AHitThatIsSetWithoutHitIsTold()
    {
        const string said =
            "HitParameter or HitModel was set without a call of Hit. Call ray.Hit(t, this): it keeps the nearest hit that counts.";
        Assert.Equal(said, Said((_, ray) => ray.HitParameter = 3));
        Assert.Equal(said, Said((model, ray) => (ray.HitParameter, ray.HitModel) = (3, model)));
    }

    [Theory]
    [InlineData(3.000002, "expected t = 3, but got t = 3.000002 (equal to 6 digits: a float?).")]
    [InlineData(3.001, "expected t = 3, but got t = 3.001.")]
    public void EqualToTheDigitsOfAFloatIsTold(double t, string said) => Assert.Equal(said, Said((model, ray) => ray.Hit(t, model)));

    [Fact]
    public void NoHitIsNotEqualToAHit()
    {
        Assert.False(RayAssert.AreEqual(double.PositiveInfinity, 5));
        Assert.False(RayAssert.AreEqual(5, double.PositiveInfinity));
        Assert.False(RayAssert.AreEqual(double.PositiveInfinity, double.NegativeInfinity));
        Assert.True(RayAssert.AreEqual(double.PositiveInfinity, double.PositiveInfinity));
    }

    [Fact]
    public void TheNumbersOnTheWayAreTold() => Assert.Contains(
        "\n  Right  (Q − P)·n = −3, d·n = −1, t = 3\n",
        Assert.Throws<FailException>(() => RayAssert.Hits(Slide, plane, new(3, 0, 0), new(-1, 0, 0), 3, (_, _) => { }))
            .Message.ReplaceLineEndings("\n"));

    [Fact]
    public void OfALengthIsSpokenOnlyWhereOneIsAskedFor()
    {
        Assert.DoesNotContain("whose length", Said(isUnit: false));
        Assert.Contains("whose length is 2, not 1", Said(isUnit: true));

        static string Said(bool isUnit) =>
            Assert.Throws<FailException>(() => RayAssert.Equal("d", Slide, new(1, 0, 0), new Vector3(2, 0, 0), isUnit)).Message;
    }

    /// <summary>The far side of a box that zNear, the bias or zFar cuts, by a body that stores the first t &gt; 0.</summary>
    [Fact]
    public void ANearSideThatIsCutOffIsAskedFor()
    {
        var box = RayCaster.Model.Of(new RayCaster.Aabb(new(-1, -1, -1), new(1, 1, 1)));
        RayAssert.Agrees(Slide, box, new(5, 0, 0), new(0, 0.1, 0.1));
        Assert.Contains("Bias = ", Assert.Throws<FailException>(() => RayAssert.Agrees(Slide, box, new(5, 0, 0), new(0, 0.1, 0.1), (model, ray) =>
        {
            var watched = new Ray(ray.Origin, ray.Direction);
            model.Intersect(watched);
            ray.Hit(watched.HitParameter, model);
        })).Message);
    }

    [Fact]
    public void AColourThatShadeChangesIsTold()
    {
        var model = new Plane(Vector3.Zero, new(1, 0, 0));
        var untouched = new Untouched(("ray.HitModel", model));
        model.Color.R *= 0.5;
        var failure = Assert.Throws<FailException>(() => untouched.Check("Primitive Shading"));
        Assert.StartsWith("the call has changed ray.HitModel.Color.R from 1 to 0.5.", failure.Message);
    }
}
