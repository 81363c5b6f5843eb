namespace RayCaster.Ci;

/// <summary>What a job's end means.</summary>
/// <param name="Passed">How many tests have passed; a command without tests is one.</param>
/// <param name="FailedTests">The tests that have failed.</param>
/// <param name="Skipped">What was skipped: a test, or the command, and why.</param>
/// <param name="Faults">What is wrong beside them.</param>
internal sealed record Verdict(int Passed, IReadOnlyList<TestResult> FailedTests, IReadOnlyList<(string Name, string Reason)> Skipped,
    IReadOnlyList<string> Faults)
{
    /// <summary>A script that cannot do its work here ends with it, and says why in its last line.</summary>
    public const int Skip = 77;

    /// <summary>The exit code of "dotnet test" when tests have failed, and nothing else.</summary>
    private const int TestsFailed = 2;

    /// <summary>How many have failed.</summary>
    public int Failed => FailedTests.Count + Faults.Count;

    /// <summary>Judges a job by how its command ended and by the reports that it left.</summary>
    public static Verdict Of(Job job, Execution end, IReadOnlyList<TestReport> reports)
    {
        var tests = reports.SelectMany(report => report.Tests).ToArray();
        var failed = tests.Where(test => test.Failure is not null).ToArray();
        var skipped = tests.Where(test => test.Reason is not null).Select(test => (test.Name, test.Reason!)).ToList();
        var passed = tests.Length - failed.Length - skipped.Count;
        var faults = new List<string>();
        if (end.ExitCode is null) faults.Add($"it was not done after {job.Minutes} minutes, and was killed");
        else if (end.ExitCode == Skip && reports.Count == 0)
            skipped.Add(("all", end.Output.LastOrDefault(line => line.Trim() != "", "it does not say why")));
        else
        {
            if (end.ExitCode != 0 && !(end.ExitCode == TestsFailed && failed.Length > 0)) faults.Add($"its exit code is {end.ExitCode}");
            else if (job.Reports == 0) passed++;
            if (reports.Count != job.Reports) faults.Add($"{reports.Count} test programs left a report, not {job.Reports}");
        }
        faults.AddRange(reports.Where(report => report.Tests.Count == 0).Select(report => $"{report.Program} ran no test"));
        if (end.PeakMegabytes > job.Megabytes)
            faults.Add($"{end.PeakProgram} took {end.PeakMegabytes:N0} MB of memory; at most {job.Megabytes:N0} MB are allowed");
        return new(passed, failed, skipped, faults);
    }
}
