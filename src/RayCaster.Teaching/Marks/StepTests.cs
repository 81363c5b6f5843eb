using System.Xml;
using System.Xml.Linq;

namespace RayCaster.Teaching;

/// <summary>What an item's points depend on.</summary>
public enum ItemEvidence
{
    /// <summary>The pictures alone.</summary>
    Pictures,

    /// <summary>The step tests alone.</summary>
    Tests,

    /// <summary>Both: the tests decide what the pictures leave undecided; where the two contradict each other, nothing is decided.</summary>
    Both,
}

/// <summary>How many tests of a step pass, and of how many.</summary>
internal sealed record StepResult(int Step, int Passed, int Count)
{
    public bool IsPassed => Passed == Count;

    /// <summary>Whether the tests say something about their step: they fail, too, where a step fails that they use.</summary>
    public bool IsTelling(IReadOnlyDictionary<int, StepResult> all) =>
        IsPassed || !Enumerable.Range(1, Step is 4 or 5 ? 3 : 2).Any(used => used < Step && all.GetValueOrDefault(used) is { IsPassed: false });

    public override string ToString() => $"{Passed} of {Count} tests of step {Step} pass";
}

/// <summary>Runs the teacher's copy of a hand-out's tests with a submission's <c>Lab.dll</c> in place of the lab's.</summary>
/// <remarks>
/// What a program computes and what its tests report are in one process, so a program can forge the report. The tests that compare pictures are left
/// out: they show the mistakes of all steps before.
/// </remarks>
internal sealed class StepTests(Rubric rubric, ProgramRunner programs)
{
    /// <summary>The assembly that a submission's build makes.</summary>
    public const string Lab = "Lab.dll";

    private const string Tests = "Lab.Tests.dll", Report = "steps.xml", Filter = "FullyQualifiedName~Lab.Tests.Step&FullyQualifiedName!~ThePictures";
    private const long MaxReportBytes = 1 << 22;

    /// <summary>The folder of the tests that were built last in a hand-out; null if none were.</summary>
    public static string? BuiltIn(string handOut) => !Directory.Exists(handOut) ? null
        : Directory.EnumerateFiles(handOut, Tests, SearchOption.AllDirectories)
            .Where(file => File.Exists(Path.Combine(Path.GetDirectoryName(file)!, "testhost.dll")))
            .MaxBy(File.GetLastWriteTimeUtc) is { } tests ? Path.GetDirectoryName(tests) : null;

    /// <summary>The results by step; none if the tests cannot run with this submission.</summary>
    /// <param name="problem">Why there are none; null if there are some.</param>
    public IReadOnlyDictionary<int, StepResult> Of(Submission submission, CancellationToken cancellation, out string? problem)
    {
        var assembly = rubric.Source.Run.First(word => word.EndsWith(Lab, StringComparison.Ordinal)).Replace("{dir}", submission.Folder);
        problem = $"the tests of the steps did not run: there is no {Path.GetRelativePath(submission.Folder, assembly)}, or it is a link";
        if (!File.Exists(assembly) || SubmissionRunner.LinkIn(submission.Folder, assembly) is not null) return new Dictionary<int, StepResult>();
        using var work = new WorkFolder();
        var folder = work.Copy([.. Directory.EnumerateFiles(rubric.Tests!), assembly], "tests");
        var limits = rubric.Source.Limits;
        var run = programs.Run(
            ["dotnet", "test", Tests, "--filter", Filter, "--logger", $"steps;junit={Report}", "--results-directory", work.Files],
            work.Place(folder, work.Files), limits, limits.BuildTime, cancellation);
        var results = Read(RegularFile.Read(Path.Combine(work.Files, Report), MaxReportBytes) ?? []);
        problem = results.Count > 0 ? null : $"the tests of the steps did not come to an end: {run.InWords(limits, limits.BuildTime)}";
        return results;
    }

    /// <summary>Counts the test cases of a JUnit report whose classes are called <c>Step01Vectors</c> and the like.</summary>
    /// <returns>Of a run that was stopped, only the steps that fail: tests of the others may be missing.</returns>
    internal static IReadOnlyDictionary<int, StepResult> Read(byte[] report)
    {
        try
        {
            using var reader = XmlReader.Create(new MemoryStream(report)); // which refuses a DTD
            var tests = XDocument.Load(reader).Descendants("testcase").ToArray();
            var isStopped = tests.Any(test => test.Element("error") is not null);
            return tests.GroupBy(StepOf).Where(step => step.Key > 0)
                .Select(step => new StepResult(step.Key, step.Count(test => !test.HasElements), step.Count()))
                .Where(step => !isStopped || !step.IsPassed).ToDictionary(step => step.Step);
        }
        catch (XmlException)
        {
            return new Dictionary<int, StepResult>(); // nothing, or what a program has forged
        }

        static int StepOf(XElement test) => ((string?)test.Attribute("classname"))?.Split(".Step") is [_, [var tens, var ones, ..]]
            && int.TryParse([tens, ones], CultureInfo.InvariantCulture, out var step) ? step : 0;
    }
}
