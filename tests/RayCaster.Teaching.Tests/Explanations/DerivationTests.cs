namespace RayCaster.Teaching.Tests.Explanations;

/// <summary>The primitives' own formulas over a number that writes down what it computes.</summary>
public class DerivationTests
{
    [Theory]
    [InlineData(50)]
    [InlineData(300, Explicit = true)]
    public void EveryFormulaGivesTheSameBitsAsPlainDoubles(int scenes)
    {
        var random = new Random(20);
        for (var i = 0; i < scenes; i++)
        {
            var scene = RandomScene.Make(random);
            var (c, r) = (random.Next(scene.Camera.Width), random.Next(scene.Camera.Height));
            var (plain, derived) = (scene.Camera.Direction<Scalar>(c, r), scene.Camera.Direction<Derivation>(c, r));
            AssertSame([plain.X, plain.Y, plain.Z], [derived.X, derived.Y, derived.Z]);
            var depthPerT = scene.Camera.DepthPerT(derived);
            AssertSame([scene.Camera.DepthPerT(plain)], [depthPerT]);
            foreach (var model in scene.Models)
                foreach (var shape in Some.ShapesOf(model))
                {
                    var expected = shape.Intersect(new Ray<Scalar>(scene.Camera.Position, plain))!.Value;
                    var crossings = shape.Intersect(new Ray<Derivation>(scene.Camera.Position, derived))!.Value;
                    AssertSame([expected.Near, expected.Far], [crossings.Near, crossings.Far]);
                    AssertSame(
                        [scene.Camera.ClipRange.First(expected, scene.Camera.DepthPerT(plain))],
                        [scene.Camera.ClipRange.First(crossings, depthPerT)]);
                    AssertSame([scene.Attenuation(expected.Near)], [scene.Attenuation(crossings.Near)]);
                }
        }
    }

    [Fact]
    public void AVectorIsWrittenAsThreeNumbersAndADotProductAsOne()
    {
        var t = new Plane(new(-5, 0, 0), new(1, 0, 0)).Intersect(Along(-1, 0, 0)).Near;
        Assert.Equal(25, t.Value);
        var step = Assert.Single(NamedValue.LeadingTo(t));
        Assert.Equal(("t", "(Q − P) · n / (d · n)"), (step.Name, step.Formula));
        Assert.Equal("((−5, 0, 0) − (20, 0, 0)) · (1, 0, 0) / ((−1, 0, 0) · (1, 0, 0))", step.Numbers);
    }

    [Fact]
    public void StepsComeInTheOrderOfTheFormula()
    {
        var crossings = new Sphere(new(0, 0, 0), 4).Intersect(Along(-1, 0, 0));
        var (near, far) = (crossings.Near.Value, crossings.Far.Value);
        Assert.True(
            (near, far) == (16, 24),
            $"P = (20, 0, 0), d = (−1, 0, 0), sphere C = (0, 0, 0), R = 4: expected t = 16 and 24, but got {near} and {far}");
        var steps = NamedValue.LeadingTo(crossings.Near, crossings.Far);
        Assert.Equal(["L", "t_ca", "D", "t_hc"], steps.Select(step => step.Name));
        Assert.Equal("√(16 − (0, 0, 0) · (0, 0, 0))", steps[3].Numbers);
        Assert.Equal("20 − 4", new TermText().Write(crossings.Near.Term));
    }

    [Fact]
    public void BracketsStandWhereTheOrderOfTheOperationsNeedsThem()
    {
        Derivation a = 2, b = 3, c = -4;
        Assert.Equal("2 − (3 − 2)", new TermText().Write((a - (b - a)).Term));
        Assert.Equal("2 − 3 − 2", new TermText().Write((a - b - a).Term));
        Assert.Equal("(2 + 3) · (−4)", new TermText().Write(((a + b) * c).Term));
        Assert.Equal("−4 · 2 + (−4) · 3", new TermText().Write((c * a + c * b).Term));
        Assert.Equal("2 / (3 / (−4))", new TermText().Write((a / (b / c)).Term));
        Assert.Equal("−(2 + 3)", new TermText().Write((-(a + b)).Term));
    }

    [Fact]
    public void AFailedTestIsToldWithItsNumbers()
    {
        var t = new Ring(new(0, 0, 0), new(1, 0, 0), 1, 2).Intersect(new Ray<Derivation>(new Vector3(20, 3, 0), new Vector3(-1, 0, 0))).Near;
        Assert.Equal(double.NaN, t.Value);
        Assert.EndsWith("= 9 ≤ 4 is false", NaNReason.IsNoNumber(t.Term));
    }

    [Fact]
    public void ARootOfANegativeNumberIsToldAsTheCause()
    {
        Derivation square = 4;
        Assert.Equal("√(4 − 9) is no number", NaNReason.IsNoNumber((1 + Derivation.Sqrt(square - 9)).Term));
    }

    private static void AssertSame(Scalar[] expected, Derivation[] actual) =>
        Assert.Equal(expected.Select(x => BitConverter.DoubleToInt64Bits(x.Value)), actual.Select(x => BitConverter.DoubleToInt64Bits(x.Value)));

    private static Ray<Derivation> Along(double x, double y, double z) =>
        new(((Vector3<Derivation>)new Vector3(20, 0, 0)).As("P", ""), ((Vector3<Derivation>)new Vector3(x, y, z)).As("d", ""));
}
