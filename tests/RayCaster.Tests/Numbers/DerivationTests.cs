namespace RayCaster.Tests.Numbers;

/// <summary>The primitives' own formulas over a number that writes down what it computes tell how a crossing came about.</summary>
public class DerivationTests
{
    [Fact]
    public void ThePlaneWritesDownTheSlidesFormula()
    {
        var t = new Plane(new(-5, 0, 0), new(1, 0, 0)).Cross(Along(-1, 0, 0)).Near;
        Assert.Equal(25, t.Value);
        Assert.Equal("(((-5 - 20) * 1 + (0 - 0) * 0) + (0 - 0) * 0) / ((-1 * 1 + 0 * 0) + 0 * 0)", t.Text);
    }

    [Fact]
    public void TheSphereTellsWhatItTookTheRootOf()
    {
        var crossings = new Sphere(new(0, 0, 0), 4).Cross(Along(-1, 0, 0));
        Assert.Equal((16, 24), (crossings.Near.Value, crossings.Far.Value));
        Assert.Contains("sqrt((16 - ", crossings.Near.Text);
    }

    [Fact]
    public void TheTriangleTellsWhichTestItFails()
    {
        var t = new Triangle(new(0, 5, 0), new(0, 6, 0), new(0, 5, 1)).Cross(Along(-1, 0, 0)).Near;
        Assert.Equal(double.NaN, t.Value);
        Assert.Contains(" >= 0", t.Text);
    }

    private static Ray<Derivation> Along(double x, double y, double z) => new(new Vector3(20, 0, 0), new Vector3(x, y, z));
}
