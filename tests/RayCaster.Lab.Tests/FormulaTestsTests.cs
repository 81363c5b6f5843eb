namespace Lab.Tests;

/// <summary>A failed picture test asks first that the tests of formulas pass.</summary>
public class FormulaTestsTests
{
    [Fact]
    public void OfTheSolvedLabNoneFails() => Assert.Null(FormulaTests.FirstFailure(3)); // the tests themselves run here, too

    [Fact]
    public void TheFirstThatFailsIsToldWithItsMessage() => Assert.Equal(
        "Failing.WithArguments: 2 is wrong", FormulaTests.FirstFailure([typeof(Failing)]));

    [Fact]
    public void TheStepsAreAskedInTheGivenOrder() => Assert.Equal(
        "Own.Fails: of the picture's own step", FormulaTests.FirstFailure([typeof(Own), typeof(Failing)]));

#pragma warning disable xUnit1000 // not public, so that it is no test of this project
    private sealed class Failing : StepTests
    {
        [Fact]
        public void Passes() { }

        [Theory]
        [InlineData(1)]
        [InlineData(2)]
        public void WithArguments(int number) => Assert.True(number == 1, $"{number} is wrong\nmore");

        [Fact]
        public void Later() => Assert.Fail("this one is not reached");

        [Fact]
        public void ThePictures() => Assert.Fail("this is what asks");
    }

    private sealed class Own : StepTests
    {
        [Fact]
        public void Fails() => Assert.Fail("of the picture's own step");
    }
}
