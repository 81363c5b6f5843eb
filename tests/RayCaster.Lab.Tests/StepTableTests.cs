using System.Xml.Linq;
using Lab.TestLogger;
using Microsoft.VisualStudio.TestPlatform.ObjectModel;

namespace Lab.Tests;

/// <summary>What the end of a hand-out's test run says, and its JUnit report; above all of a run that was stopped.</summary>
public sealed class StepTableTests : IDisposable
{
    private const string
        Sphere = "Lab.Tests.Step08Sphere.RandomRays", Vectors = "Lab.Tests.Step01Vectors.TheSlidesNumbers", Ray = "Lab.Tests.Step02Ray.RandomPoints",
        Why = "The run was stopped in this test. Probably your code has an endless loop, or methods that call each other without end.";

    private readonly string folder = Directory.CreateTempSubdirectory().FullName;

    public void Dispose() => Directory.Delete(folder, true);

    private static TestResult Result(string name, TestOutcome outcome = TestOutcome.Passed)
    {
        var test = new TestCase(name, new("executor://test"), "Lab.Tests.dll") { DisplayName = name };
        test.Traits.Add("step", int.Parse(name.Split(".Step")[1][..2]).ToString());
        return new(test) { Outcome = outcome, DisplayName = name };
    }

    /// <summary>The tests that have not ended, as they are read from the file of the process that was stopped.</summary>
    private (string, string)[] Running(params (string Name, bool Ended)[] tests)
    {
        var file = Path.Combine(folder, "tests.begun");
        var begun = new TestsBegun(file);
        foreach (var (name, ended) in tests)
        {
            begun.Begin(name, name + "(way: 1)");
            if (ended) begun.End(name, name + "(way: 1)");
        }
        var running = TestsBegun.Running(file); // while it is open
        begun.Dispose();
        return running;
    }

    private static string[] Names(IEnumerable<TestResult> stopped) => [.. stopped.Select(test => test.DisplayName)];

    [Fact]
    public void ARunToItsEndCountsTheTestsOfEachStep() => Assert.Equal(
        ["", "Step  Tests that pass", "   2   1 of  1    done  ray", "   8   1 of  2          sphere"],
        StepTable.Lines([Result(Sphere), Result(Ray), Result(Sphere, TestOutcome.Failed)], []));

    [Fact]
    public void OfARunThatWasStoppedNoStepIsDone()
    {
        var stopped = StoppedTests.Of(Running((Ray, true), (Sphere, true), (Sphere, false)), []);
        Assert.Equal(
            ["", "Step  Tests that pass", "   2   1 of  ?          ray", "   8  stopped           sphere", $"\n{Sphere}(way: 1)\n  {Why}"],
            StepTable.Lines([Result(Sphere), Result(Ray)], stopped));
    }

    [Fact]
    public void ATestThatWasStoppedIsAnErrorOfTheReport()
    {
        var file = Path.Combine(folder, "report", "step8.xml");
        JUnitReport.Write(file, [Result(Ray)], StoppedTests.Of(Running((Sphere, false)), []));
        var suite = XDocument.Load(file).Descendants("testsuite").Single();
        Assert.Equal(("2", "0", "1"), ((string)suite.Attribute("tests"), (string)suite.Attribute("failures"), (string)suite.Attribute("errors")));
        var error = suite.Elements("testcase").Single(test => test.Attribute("name").Value == "RandomRays(way: 1)").Element("error");
        Assert.Equal(Why, (string)error.Attribute("message"));
    }

    [Fact]
    public void AStackOverflowIsOfTheTestOnTheStack() => Assert.Equal([Vectors], Names(StoppedTests.Of(
        Running((Ray, false), (Vectors, false)),
        [$"   at {Sphere}()", "Stack overflow.", $"   at Lab.Vector3.op_Multiply(Double, Lab.Vector3)\n   at {Vectors}()"])));

    [Fact]
    public void ACallStackIsToldUpToTheTest() => Assert.Equal(
        $"Stack overflow.\n   at Lab.Vector3.op_Multiply(Lab.Vector3, Lab.Vector3)\n   at {Vectors}()",
        StoppedTests.WithoutForeignCalls(
            $"Stack overflow.\n   at Lab.Vector3.op_Multiply(Lab.Vector3, Lab.Vector3)\n   at {Vectors}()\n   at System.Reflection.Invoke()"));

    [Fact]
    public void OfAFailuresStackTheLabsOwnCallsAreTold() => Assert.Equal(
        $"   at Lab.Sphere.GeometricSolution(Ray ray) in Sphere.cs:line 18\n   at {Sphere}() in Step08Sphere.cs:line 43",
        StoppedTests.OwnCalls("   at Lab.Sphere.GeometricSolution(Ray ray) in Sphere.cs:line 18\n" +
            $"   at {Sphere}() in Step08Sphere.cs:line 43\n" +
            "   at System.Reflection.MethodBaseInvoker.InvokeWithNoArgs(Object obj, BindingFlags invokeAttr) in MethodBaseInvoker.cs:line 57"));

    [Fact]
    public void ARunThatWasStoppedIsAnErrorEvenIfNoTestIsKnown() => Assert.Single(StoppedTests.Of([], []));
}
