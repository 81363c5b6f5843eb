namespace RayCaster.Teaching.Tests.Changes;

/// <summary>Slips.txt: a slip of one's own is a few lines of text.</summary>
public class MutationBookTests
{
    [Theory]
    [InlineData("n² → 7·n", "t_hc = √(7·R − D2)", 2)]
    [InlineData("n² → 7·n [+0.5]", "t_hc = √(7·R − D2)", 2.5)]
    [InlineData("n² → 1 | 7·n", "t_hc = √(7·R − D2)", 2)]
    [InlineData("not in plane: n² → 7·n", "t_hc = √(7·R − D2)", 2)]
    [InlineData("in sphere: R → C.x", "t_hc = √(C.x² − D2)", 2.2)] // by that step's names; it is twice in the formula
    public void ARuleIsTriedWhereItsLeftSideFits(string rule, string formula, double cost)
    {
        var mutation = Assert.Single(Mutations(rule), mutation => mutation.Step.Formulas[3].ToString() == formula);
        Assert.Equal((cost, "Which power is it?"), (mutation.Cost, mutation.Operator.Question));
    }

    [Theory]
    [InlineData("not in sphere: n² → 7·n")]
    [InlineData("in plane: n² → 7·n")]
    [InlineData("number² → 7·number")]
    public void WhereItDoesNotFitNothingIsMade(string rule) =>
        Assert.DoesNotContain(Mutations(rule), mutation => mutation.Step.Formulas[3].ToString() == "t_hc = √(7·R − D2)");

    [Fact]
    public void WhatStudentsAreToldIsText() => Assert.All(Mutations("n² → 7·n"),
        mutation => Assert.Equal("R² became 7·R", mutation.Operator.Tell("R²", "7·R")));

    [Theory]
    [InlineData("n² → n·m", "unknown name 'm'")]
    [InlineData("in ball: n² → n", "unknown step 'ball'")]
    [InlineData("n² → n [cheap]", "'cheap' where a number is expected")]
    [InlineData("n → v", "unknown name 'v'")]
    [InlineData("n → (n, n, n)", "is of another kind")]
    public void AWrongRuleIsToldWithItsSlip(string rule, string message)
    {
        var error = Assert.Throws<FormatException>(() => Mutations(rule));
        Assert.StartsWith("Slips.txt: [Sevenfold]: ", error.Message, StringComparison.Ordinal);
        Assert.Contains(message, error.Message, StringComparison.Ordinal);
    }

    /// <summary>What a text with a slip more makes of the sphere's formulas by it.</summary>
    private static IEnumerable<Mutation> Mutations(string rule)
    {
        var text = $"{FormulaBook.TextOf("Slips.txt")}\n[Sevenfold]\ncost 2\nquestion Which power is it?\nanswer MEANT became WRITTEN\n{rule}";
        return MutationFactory.MutationsOf(FormulaBook.Slides.StylesOf(StepKind.Sphere)[0], new(text))
            .Where(mutation => mutation.Operator.ToString() == "Sevenfold");
    }
}
