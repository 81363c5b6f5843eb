using System.Diagnostics;

namespace Lab.Tests;

/// <summary>Slides "C# Objects", "IDE &amp; Vectors".</summary>
[Trait("step", "1")]
public class Step01Vectors : StepTests
{
    private const string Slide = "IDE & Vectors";

    private readonly Chance chance = new();

    [Fact]
    public void ClassesAreReferencesSoTwoNamesMayNameOneVector()
    {
        var P = new Vector3(1, 2, 3);
        var Q = P;
        P.X = 3;
        Assert.Equal(3, Q.X);
    }

    [Fact]
    public void NobodyCanChangeEverybodysZero()
    {
        var zero = Vector3.Zero;
        zero.X = 1;
        Assert.Equal(0, Vector3.Zero.X);
    }

    [Fact]
    public void TheSlidesNumbers()
    {
        var P = new Vector3(20, 0, 0);
        RayAssert.Equal("P - Zero", Slide, new(20, 0, 0), P - Vector3.Zero);
        RayAssert.Equal("(1, 2, 3) + (4, -5, 6)", Slide, new(5, -3, 9), new Vector3(1, 2, 3) + new Vector3(4, -5, 6));
        RayAssert.Equal("2.0 * (1, -2, 3)", Slide, new(2, -4, 6), 2.0 * new Vector3(1, -2, 3));
        RayAssert.Equal("(1, 2, 3) * (4, -5, 6), the dot product", Slide, 12, new Vector3(1, 2, 3) * new Vector3(4, -5, 6));
        RayAssert.Equal("(1, 0, 0) % (0, 1, 0), the cross product", Slide, new(0, 0, 1), new Vector3(1, 0, 0) % new Vector3(0, 1, 0));
        RayAssert.Equal("the length of (1, 2, 2)", Slide, 3, new Vector3(1, 2, 2).Length);
        RayAssert.Equal("(0, 0, -2) normalised", Slide, new(0, 0, -1), new Vector3(0, 0, -2).Normalized, isUnit: true);
    }

    [Fact]
    public void OperatorsMakeNewVectorsAndLeaveTheirOperandsAlone()
    {
        AssertLeavesOperandsAlone("a + b", (a, b) => a + b);
        AssertLeavesOperandsAlone("a - b", (a, b) => a - b);
        AssertLeavesOperandsAlone("2 * a", (a, _) => 2 * a);
        AssertLeavesOperandsAlone("a % b", (a, b) => a % b);
        AssertLeavesOperandsAlone("a.Normalized", (a, _) => a.Normalized);
    }

    [Fact]
    public void RandomVectors()
    {
        for (var i = 0; i < Teacher.Rays; i++)
        {
            var (a, b, k) = (chance.Point(), chance.Point(), chance.Number());
            var (A, B) = (RayAssert.Text(a), RayAssert.Text(b));
            RayAssert.Equal($"{A} + {B}", Slide, a + b, X() + Y());
            RayAssert.Equal($"{A} - {B}", Slide, a - b, X() - Y());
            RayAssert.Equal($"{RayAssert.Text(k)} * {A}", Slide, k * a, k * X());
            RayAssert.Equal($"{A} * {B}", Slide, a * b, X() * Y());
            RayAssert.Equal($"{A} % {B}", Slide, a % b, X() % Y());
            RayAssert.Equal($"the length of {A}", Slide, a.Length, X().Length);

            Vector3 X() => RayAssert.Mine(a); // new ones, in case an operator changes its operands
            Vector3 Y() => RayAssert.Mine(b);
        }
    }

    [StackTraceHidden]
    private static void AssertLeavesOperandsAlone(string what, Func<Vector3, Vector3, Vector3> calculate)
    {
        Vector3 a = new(1, 2, 3), b = new(4, 5, 6);
        var result = calculate(a, b);
        RayAssert.Equal($"a after {what}", Slide, new(1, 2, 3), a);
        RayAssert.Equal($"b after {what}", Slide, new(4, 5, 6), b);
        Assert.True(result != a && result != b, $"{what}: expected a new vector, but got the operand.\n  {RayAssert.Cite(Slide)}");
    }
}
