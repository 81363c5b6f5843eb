using Microsoft.VisualStudio.TestPlatform.ObjectModel;
using Microsoft.VisualStudio.TestPlatform.ObjectModel.Client;
using Microsoft.VisualStudio.TestPlatform.ObjectModel.Logging;

namespace Lab.TestLogger;

/// <summary>Ends a test run with a table of the steps; with a parameter "junit" it writes a JUnit report, too.</summary>
[FriendlyName("steps")]
[ExtensionUri("logger://lab/steps")]
public sealed class StepTable : ITestLoggerWithParameters
{
    private readonly List<TestResult> results = [];

    private readonly List<string> messages = []; // the call stack of a stack overflow is one of them

    private string report;

    public void Initialize(TestLoggerEvents events, string testRunDirectory)
    {
        events.TestResult += (_, args) =>
        {
            // The console's logger comes after this one. It gets the lab's own calls: xunit's and the runtime's help nobody here.
            args.Result.ErrorStackTrace = StoppedTests.OwnCalls(args.Result.ErrorStackTrace ?? "");
            results.Add(args.Result);
        };
        events.TestRunMessage += (_, args) =>
        {
            messages.Add(args.Message);
            if (args.Message.EndsWith(" [FAIL]")) args.Level = TestMessageLevel.Informational;
            else args.Message = StoppedTests.WithoutForeignCalls(args.Message);
        };
        events.TestRunComplete += (_, args) =>
        {
            var isStopped = args.IsAborted || args.IsCanceled;
            Finish(isStopped ? StoppedTests.Of(TestsBegun.Running(TestsBegun.Path), messages) : []);
            // The console's logger would end with "Passed!" of the tests before.
            if (isStopped) Environment.Exit(1);
        };
    }

    public void Initialize(TestLoggerEvents events, Dictionary<string, string> parameters)
    {
        var folder = parameters[DefaultLoggerParameterNames.TestRunDirectory];
        if (parameters.TryGetValue("junit", out var file)) report = Path.Combine(folder, file);
        Initialize(events, folder);
    }

    private void Finish(List<TestResult> stopped)
    {
        foreach (var line in Lines(results, stopped)) Console.WriteLine(line);
        if (report != null) JUnitReport.Write(report, results, stopped);
    }

    /// <param name="results">Of the tests that have ended.</param>
    /// <param name="stopped">If the run was stopped, the tests that were running, at least one.</param>
    internal static IEnumerable<string> Lines(IReadOnlyCollection<TestResult> results, IReadOnlyCollection<TestResult> stopped)
    {
        yield return "";
        yield return "Step  Tests that pass";
        foreach (var step in results.Concat(stopped).GroupBy(StepOf).Where(step => step.Key > 0).OrderBy(step => step.Key))
        {
            var (passed, all) = (step.Count(result => result.Outcome == TestOutcome.Passed), step.Count());
            var isUnfinished = step.Any(result => result.ErrorMessage?.Contains("which is not written yet") == true);
            var count = step.Any(stopped.Contains) ? "stopped"
                : isUnfinished ? "unfinished"
                : stopped.Count > 0 ? $"{passed,2} of  ?" // others may not have begun
                : $"{passed,2} of {all,2}";
            yield return $"{step.Key,4}  {count,-10}  {(passed == all && stopped.Count == 0 ? "done" : ""),-4}  {NameOf(step)}";
        }
        if (stopped.Count == 0 && Enumerable.Range(1, 10).All(step => results.Any(result => StepOf(result) == step))
            && results.All(result => result.Outcome == TestOutcome.Passed))
            yield return "\nAll ten steps are done: this is a ray caster. Draw a scene of your own.";
        foreach (var test in stopped) yield return $"\n{test.DisplayName}\n  {test.ErrorMessage}";
    }

    private static int StepOf(TestResult result) =>
        int.TryParse(result.TestCase.Traits.FirstOrDefault(trait => trait.Name == "step")?.Value, out var step) ? step : 0;

    /// <summary>What a step is about, from the name of its class: Step07Box.</summary>
    private static string NameOf(IEnumerable<TestResult> step)
    {
        const string prefix = ".Step";
        var name = step.Select(result => result.TestCase.FullyQualifiedName).First(name => name.Contains(prefix));
        return name[(name.IndexOf(prefix) + prefix.Length + 2)..].Split('.')[0].ToLowerInvariant();
    }
}
