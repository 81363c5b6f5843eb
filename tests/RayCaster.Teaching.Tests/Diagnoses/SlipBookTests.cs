namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Slips.txt: a slip of one's own is a few lines of text.</summary>
public class SlipBookTests
{
    [Theory]
    [InlineData("n² → n·n·n", "t_hc = √(R·R·R − D2)", 2)]
    [InlineData("n² → n·n·n [+0.5]", "t_hc = √(R·R·R − D2)", 2.5)]
    [InlineData("n² → 1 | n·n·n", "t_hc = √(R·R·R − D2)", 2)]
    [InlineData("not in plane: n² → n·n·n", "t_hc = √(R·R·R − D2)", 2)]
    [InlineData("in sphere: R → C.x", "t_hc = √(C.x² − D2)", 2.2)] // by that step's names; it is twice in the formula
    public void ARuleIsTriedWhereItsLeftSideFits(string rule, string formula, double cost)
    {
        var mutant = Assert.Single(Mutants(rule), mutant => mutant.Section.Formulas[3].ToString() == formula);
        Assert.Equal((cost, "Is it an area, or a volume?"), (mutant.Cost, mutant.Operator.Question));
    }

    [Theory]
    [InlineData("not in sphere: n² → n·n·n")]
    [InlineData("in plane: n² → n·n·n")]
    [InlineData("n² → √n²")] // a letter alone binds more tightly
    public void WhereItDoesNotFitNothingIsMade(string rule) =>
        Assert.DoesNotContain(Mutants(rule), mutant => mutant.Section.Formulas[3].ToString() == "t_hc = √(R·R·R − D2)");

    [Fact]
    public void WhatStudentsAreToldIsText() => Assert.All(Mutants("n² → n·n·n"),
        mutant => Assert.Equal("R² became R·R·R", mutant.Operator.Tell("R²", "R·R·R")));

    [Theory]
    [InlineData("n² → n·m", "unknown name 'm'")]
    [InlineData("in ball: n² → n", "unknown step 'ball'")]
    [InlineData("n² → n [cheap]", "'cheap' where a number is expected")]
    [InlineData("n → v", "unknown name 'v'")]
    [InlineData("n → (n, n, n)", "is of another kind")]
    public void AWrongRuleIsToldWithItsSlip(string rule, string message)
    {
        var error = Assert.Throws<FormatException>(() => Mutants(rule));
        Assert.StartsWith("Slips.txt: [Cubed]: ", error.Message, StringComparison.Ordinal);
        Assert.Contains(message, error.Message, StringComparison.Ordinal);
    }

    /// <summary>What a text with a slip more makes of the sphere's formulas by it.</summary>
    private static IEnumerable<Mutant> Mutants(string rule)
    {
        var text = $"{FormulaBook.TextOf("Slips.txt")}\n[Cubed]\ncost 2\nquestion Is it an area, or a volume?\nanswer MEANT became WRITTEN\n{rule}";
        return MutantFactory.MutantsOf(FormulaBook.Slides.StylesOf(StepKind.Sphere)[0], new(text))
            .Where(mutant => mutant.Operator.ToString() == "Cubed");
    }
}
