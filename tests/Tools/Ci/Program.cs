using System.Runtime.InteropServices;

namespace RayCaster.Ci;

/// <summary>
/// Runs the jobs of jobs.json that this commit asks for, or those whose names it is given, in the root folder. Environment: WHOLE=yes for all
/// jobs, as once a week; REQUIRE=all where nothing may be skipped that this system can do; SINCE, a commit from which on the changes say which jobs
/// run, if this machine knows of none that has passed; RAYCASTER_SEED for what is random.
/// </summary>
internal static class Program
{
    private static int Main(string[] names)
    {
        using var interrupt = PosixSignalRegistration.Create(PosixSignal.SIGINT, Stop);
        using var terminate = PosixSignalRegistration.Create(PosixSignal.SIGTERM, Stop);
        try
        {
            return Run(names) ? 0 : 1;
        }
        catch (Exception e) // whatever it is, the run has failed
        {
            Console.WriteLine(e);
            Console.WriteLine("0 passed, 1 failed");
            return 1;
        }
    }

    private static bool Run(string[] names)
    {
        var week = Variable("WHOLE") is not null;
        var record = Record.OfUser();
        var lastPassed = record.LastPassed(Repository.Ancestors);
        var changed = Repository.ChangedSince(lastPassed ?? Variable("SINCE") ?? "HEAD~1");
        var table = Job.ReadTable(File.ReadAllText("tests/Tools/Ci/jobs.json"));
        foreach (var name in names.Except(table.Select(job => job.Name))) throw new ArgumentException($"jobs.json has no job {name}");
        var jobs = table.Where(job => names.Length > 0 ? names.Contains(job.Name) : job.IsDue(week, changed))
            .Where(job => job.If is null || Holds(job.If, "")).ToArray();

        // For each commit the same random numbers, so that a failure is one again; every week other ones.
        var seed = Variable("RAYCASTER_SEED") ?? $"{(week ? Random.Shared.Next(1, 1 << 24) : Repository.Seed)}";
        Console.WriteLine($"RAYCASTER_SEED={seed}");
        var environment = new Dictionary<string, string>
        {
            ["RAYCASTER_SEED"] = seed,
            ["LAB_SEED"] = seed,
            ["WHOLE"] = week ? "yes" : "",
            ["NOT_WEEKLY"] = week ? "" : "--filter-not-trait runs=weekly",
        };
        foreach (var job in names.Length > 0 ? [] : table.Except(jobs)) Console.WriteLine($"not in this run: {job.Name}");

        var folder = Directory.CreateTempSubdirectory("raycaster-ci-").FullName;
        var allowed = new AllowedSkips(File.ReadAllLines("tests/allowed-skips.txt"), Holds);
        var run = new Run(folder, allowed, Variable("REQUIRE") == "all", environment, Print);
        run.Do(jobs, record.FailedAtFirst(lastPassed));
        var passed = run.Failed == 0 && run.Passed > 0;
        if (passed) Directory.Delete(folder, recursive: true);
        else Console.WriteLine($"All that was printed is in {folder}; the same random numbers again: RAYCASTER_SEED={seed}");
        if (passed && names.Length == 0) record.Write(Repository.Commit, run.FailedAtFirst);
        Console.WriteLine(FormattableString.Invariant($"{run.Passed} passed, {run.Failed} failed, {run.Skipped} skipped"));
        return passed;
    }

    private static string? Variable(string name) => Environment.GetEnvironmentVariable(name) is { Length: > 0 } value ? value : null;

    private static bool Holds(string condition, string argument)
    {
        using var bash = System.Diagnostics.Process.Start("bash", ["-c", "{ " + condition + "; } >/dev/null 2>&1 </dev/null", "bash", argument]);
        bash.WaitForExit();
        return bash.ExitCode == 0;
    }

    private static void Print(string text)
    {
        lock (Console.Out) Console.WriteLine(text);
    }

    private static void Stop(PosixSignalContext context) => Execution.KillAll(); // and the signal ends this program, too
}
