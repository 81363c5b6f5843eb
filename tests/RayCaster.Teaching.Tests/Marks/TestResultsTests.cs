namespace RayCaster.Teaching.Tests.Marks;

public class TestResultsTests
{
    private const string Stopped = "<error message='The run was stopped in this test. Probably ...'/>";

    private static string Count(string cases) => string.Join(", ",
        TestResults.ByStep(TestReport.Parse(System.Text.Encoding.UTF8.GetBytes($"<testsuites><testsuite>{cases}</testsuite></testsuites>"))).Values);

    private static string Case(string type, string name, string content = "") => $"<testcase classname='{type}' name='{name}'>{content}</testcase>";

    [Fact]
    public void TestsAreCountedByTheStepOfTheirClass() => Assert.Equal("1 of 2 tests of step 8 pass", Count(
        Case("Lab.Tests.Step08Sphere", "A") + Case("Lab.Tests.Step08Sphere", "B", "<failure/>") + Case("Lab.Tests.OwnScenes", "C")));

    [Theory]
    [InlineData("tests.test_step_7", "test_slab")] // pytest
    [InlineData("tests/step2/test_step7.py", "test_slab")]
    [InlineData("lab", "step07 slab")] // a class without a step
    public void OtherRunnersNameTheStepInTheirWays(string type, string name) =>
        Assert.Equal("1 of 1 tests of step 7 pass", Count(Case(type, name, "<system-out>text</system-out>")));

    [Fact]
    public void ATestOfOtherRunnersThatEndsInAnErrorFailsAndNoOther() => Assert.Equal(
        "1 of 1 tests of step 3 pass, 0 of 1 tests of step 8 pass",
        Count(Case("Step03", "a") + Case("Step08", "b", "<error message='NullPointerException'/>")));

    [Fact] // tests of step 3 may be missing
    public void OfARunThatWasStoppedOnlyFailuresCount() =>
        Assert.Equal("0 of 1 tests of step 8 pass", Count(Case("Step03", "a") + Case("Step08", "b", Stopped)));

    [Fact]
    public void WhatWasSkippedDoesNotCount() =>
        Assert.Equal("1 of 1 tests of step 3 pass", Count(Case("Step03", "a", "<skipped/>") + Case("Step03", "b")));

    [Fact] // they show the mistakes of all steps before
    public void TestsOfWholePicturesDoNotCount() =>
        Assert.Equal("1 of 1 tests of step 8 pass", Count(Case("Step08", "a") + Case("Step08", "ThePictures", "<failure/>")));

    [Fact] // colours of a terminal in a message
    public void AControlCharacterIsNoError() =>
        Assert.Equal("0 of 1 tests of step 8 pass", Count(Case("Step08", "a", "<failure>&#x1B;[31m</failure>")));

    [Theory]
    [InlineData("")]
    [InlineData("<testsuites><testcase")]
    [InlineData("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>")]
    public void WhatIsNoReportIsRefused(string report) =>
        Assert.Throws<ProblemException>(() => TestReport.Parse(System.Text.Encoding.UTF8.GetBytes(report)));
}
