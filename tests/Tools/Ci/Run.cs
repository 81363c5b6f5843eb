namespace RayCaster.Ci;

/// <summary>A run of jobs.</summary>
/// <param name="folder">Where the jobs' output and reports are kept.</param>
/// <param name="allowed">What may be skipped.</param>
/// <param name="all">Whether this machine must run all that its system can.</param>
/// <param name="environment">Environment variables of all jobs.</param>
/// <param name="print">Takes what there is to read.</param>
internal sealed class Run(string folder, AllowedSkips allowed, bool all, IReadOnlyDictionary<string, string> environment, Action<string> print)
{
    /// <summary>More failed tests than that are no accident, so none is run again.</summary>
    private const int MostAgain = 10;

    private readonly Dictionary<Job, (Execution End, Verdict Verdict)> results = [];

    /// <summary>The names of the tests that failed at first and passed when they were run again.</summary>
    public List<string> FailedAtFirst { get; } = [];

    /// <summary>All that has failed, in words.</summary>
    public List<string> Failures { get; } = [];

    public int Passed => results.Values.Sum(result => result.Verdict.Passed);

    public int Failed => Failures.Count;

    public int Skipped => results.Values.Sum(result => result.Verdict.Skipped.Count);

    /// <summary>Runs jobs: those that run alone one after another, then the others, then what failed and may be run again.</summary>
    /// <param name="jobs">The jobs.</param>
    /// <param name="failedBefore">The names of the tests that failed at first in the last run of another commit.</param>
    public void Do(IReadOnlyCollection<Job> jobs, IReadOnlyCollection<string> failedBefore)
    {
        foreach (var job in jobs.Where(job => job.Group is null)) Do(job);
        var groups = jobs.Where(job => job.Group is not null).GroupBy(job => job.Group);
        Task.WaitAll([.. groups.Select(group => Task.Run(() =>
        {
            foreach (var job in group) Do(job);
        }))]);
        foreach (var job in jobs) Conclude(job, failedBefore);
        PrintTable(jobs);
    }

    private void Do(Job job)
    {
        print($"== {job.Name}: {job.Command}");
        var place = Directory.CreateDirectory(Path.Combine(folder, job.Name)).FullName;
        var missing = job.Paths.Where(path => !Path.Exists(path)).ToArray();
        var end = missing.Length == 0 ? Execute(job, job.Command, place, TimeSpan.FromMinutes(job.Minutes)) : Execution.None;
        var verdict = Verdict.Of(job, end, TestReport.ReadAll(ReportsIn(place)));
        if (missing.Length > 0) verdict = verdict with { Faults = [$"there is no {string.Join(", ", missing)}"] };
        lock (results) results[job] = (end, verdict);
        print($"-- {job.Name}: {(verdict.Failed == 0 ? "ok" : "FAILED")}, {Figures(end, verdict)}");
        foreach (var test in verdict.FailedTests) print($"   {test.Name}\n{Indented(test.Failure!.Split('\n').Take(30))}");
        foreach (var fault in verdict.Faults) print($"   {fault}");
        if (verdict.Faults.Count > 0) print($"   what {job.Name} printed last:\n{Indented(end.Output.TakeLast(60))}");
    }

    private Execution Execute(Job job, string command, string place, TimeSpan limit) => Execution.Run(command, place, limit,
        [.. environment, .. job.Environment, new("FOLDER", folder),
            new("REPORT", $"--results-directory {ReportsIn(place)} --report-xunit-junit --output Detailed")]);

    private static string ReportsIn(string place) => Path.Combine(place, "reports");

    private void Conclude(Job job, IReadOnlyCollection<string> failedBefore)
    {
        var (end, verdict) = results[job];
        foreach (var test in verdict.FailedTests)
        {
            var isFinal = verdict.Faults.Count > 0 || verdict.FailedTests.Count > MostAgain || !PassesAgain(job, test);
            if (isFinal) Failures.Add($"{job.Name}: {test.Name}");
            else if (failedBefore.Contains(test.Name)) Failures.Add($"{job.Name}: {test.Name} failed at first, as in the run before");
            else
            {
                FailedAtFirst.Add(test.Name);
                results[job] = (end, results[job].Verdict with { Passed = results[job].Verdict.Passed + 1 });
            }
        }
        Failures.AddRange(verdict.Faults.Select(fault => $"{job.Name}: {fault}"));
        Failures.AddRange(verdict.Skipped.Where(skip => !allowed.Allow($"{job.Name}: {skip.Name}: {skip.Reason}", all))
            .Select(skip => $"{job.Name}: {skip.Name} is skipped, though it must run here: {skip.Reason}"));
    }

    /// <summary>Runs a test once more, alone, if it is one that waits for other processes, and says whether it passes.</summary>
    private bool PassesAgain(Job job, TestResult test)
    {
        var place = Path.Combine(folder, job.Name, $"again-{FailedAtFirst.Count}-{Failures.Count}");
        var reports = Directory.CreateDirectory(ReportsIn(place)).FullName;
        var end = Execute(job, $"'{Path.ChangeExtension(test.Program, null)}' -method '{test.Method}' -trait {WaitingTrait} -explicit on "
            + $"-noColor -noLogo -result-junit '{reports}/report.xml'", place, TimeSpan.FromMinutes(job.Minutes));
        var tests = TestReport.ReadAll(reports).SelectMany(report => report.Tests).ToArray();
        if (tests.Length == 0) return false; // it does not wait
        var passes = end.ExitCode == 0 && tests.All(again => again.Failure is null);
        print($"== again: {test.Method}: {(passes ? "passes" : "fails")}");
        if (!passes) print(Indented(end.Output.TakeLast(60)));
        return passes;
    }

    private const string WaitingTrait = "waits=yes";

    private void PrintTable(IReadOnlyCollection<Job> jobs)
    {
        var width = jobs.Max(job => job.Name.Length);
        print($"{"job".PadRight(width)}  passed  failed  skipped      time  processor  memory");
        foreach (var job in jobs)
        {
            var (end, verdict) = results[job];
            var counts = $"{verdict.Passed,6}  {verdict.Failed,6}  {verdict.Skipped.Count,7}";
            var figures = FormattableString.Invariant($"{end.Time.TotalSeconds,6:0} s  {end.ProcessorSeconds,7:0} s  {end.PeakMegabytes,4} MB");
            print($"{job.Name.PadRight(width)}  {counts}  {figures} {end.PeakProgram}");
        }
        foreach (var skips in results.SelectMany(result => result.Value.Verdict.Skipped).GroupBy(skip => skip.Reason).OrderBy(skips => skips.Key))
            print($"skipped: {skips.Count()}: {skips.Key}");
        foreach (var name in FailedAtFirst) print($"failed at first: {name}");
        foreach (var failure in Failures) print($"failed: {failure}");
    }

    private static string Figures(Execution end, Verdict verdict) => FormattableString.Invariant(
        $"{verdict.Passed} passed, {verdict.Failed} failed, {verdict.Skipped.Count} skipped; {end.Time.TotalSeconds:0} s, ")
        + FormattableString.Invariant($"{end.ProcessorSeconds:0} s of processor time, at most {end.PeakMegabytes} MB");

    private static string Indented(IEnumerable<string> lines) => string.Join('\n', lines.Select(line => "     " + line));
}
