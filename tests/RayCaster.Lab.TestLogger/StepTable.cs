using Microsoft.VisualStudio.TestPlatform.ObjectModel;
using Microsoft.VisualStudio.TestPlatform.ObjectModel.Client;

namespace Lab.TestLogger;

/// <summary>Ends a test run with a table of the steps; with a parameter "junit" it writes a JUnit report, too.</summary>
[FriendlyName("steps")]
[ExtensionUri("logger://lab/steps")]
public sealed class StepTable : ITestLoggerWithParameters
{
    private readonly List<TestResult> results = [];

    private string report;

    public void Initialize(TestLoggerEvents events, string testRunDirectory)
    {
        events.TestResult += (_, args) =>
        {
            // The console's logger comes after this one. Of the stack it gets what has a file: xunit's and the runtime's calls help nobody here.
            var stack = args.Result.ErrorStackTrace?.Split('\n').Where(line => line.Contains(".cs:line "));
            args.Result.ErrorStackTrace = string.Join('\n', stack ?? []);
            results.Add(args.Result);
        };
        events.TestRunComplete += (_, _) => Finish();
    }

    public void Initialize(TestLoggerEvents events, Dictionary<string, string> parameters)
    {
        var folder = parameters[DefaultLoggerParameterNames.TestRunDirectory];
        if (parameters.TryGetValue("junit", out var file)) report = Path.Combine(folder, file);
        Initialize(events, folder);
    }

    private void Finish()
    {
        Console.WriteLine();
        Console.WriteLine("Step  Tests that pass");
        foreach (var step in results.GroupBy(StepOf).Where(step => step.Key > 0).OrderBy(step => step.Key))
        {
            var (passed, all) = (step.Count(result => result.Outcome == TestOutcome.Passed), step.Count());
            var isUnfinished = step.Any(result => result.ErrorMessage?.Contains("which is not written yet") == true);
            var count = isUnfinished ? "unfinished" : $"{passed,2} of {all,2}";
            Console.WriteLine($"{step.Key,4}  {count,-10}  {(passed == all ? "done" : ""),-4}  {NameOf(step)}");
        }
        if (report != null) JUnitReport.Write(report, results);
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
