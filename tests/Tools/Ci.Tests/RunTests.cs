namespace RayCaster.Ci.Tests;

/// <summary>Runs with jobs of bash, whose "test programs" are scripts that write a report.</summary>
public sealed class RunTests : IDisposable
{
    private const string Linux = "sessions of processes and /proc are Linux's";

    private readonly TemporaryFolder folder = new();
    private readonly List<string> printed = [];

    public void Dispose() => folder.Dispose();

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ACommandThatEndsWellHasPassed() => AssertCounts(Run(Job("true")), passed: 1);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ACommandThatFailsIsNamedWithWhatItPrinted()
    {
        var run = Run(Job("echo so it is; exit 3"));
        AssertCounts(run, failed: 1);
        Assert.Equal(["job: its exit code is 3"], run.Failures);
        Assert.Contains("so it is", string.Join('\n', printed));
    }

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AJobThatHangsIsKilledWithItsChildrenAndNamed()
    {
        var run = Run(Job($"echo begun; (sleep 60; touch {folder["alive"]}) & sleep 60") with { Minutes = 0.01 });
        Assert.Equal(["job: it was not done after 0.01 minutes, and was killed"], run.Failures);
        Assert.Contains("begun", string.Join('\n', printed));
        Assert.DoesNotContain(Directory.GetFiles("/proc", "cmdline", new EnumerationOptions { MaxRecursionDepth = 1, RecurseSubdirectories = true }),
            file => Text(file).Contains(folder["alive"]));
    }

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AJobWithoutAReportHasFailed() => Assert.Equal(["job: 0 test programs left a report, not 1"], Run(Job("true # $REPORT")).Failures);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AReportTooFewIsAFailure() =>
        Assert.Equal(["job: 1 test programs left a report, not 2"], Run(Job(Report(Pass)) with { Reports = 2 }).Failures);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AReportWithoutATestIsAFailure() => Assert.Equal(["job: /a/A.Tests.dll ran no test"], Run(Job(Report(""))).Failures);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ACrashAfterTheTestsIsAFailure() => Assert.Equal(["job: its exit code is 134"], Run(Job(Report(Pass) + "; exit 134")).Failures);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void TestsAreCounted()
    {
        var run = Run(Job(Report(Pass + Pass + Failing + Skipped("for Windows")) + "; exit 2"));
        AssertCounts(run, passed: 2, failed: 1, skipped: 1);
        Assert.Equal(["job: N.A.Fails(x: 1)"], run.Failures);
        Assert.Contains("1 is not 2", string.Join('\n', printed));
    }

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void WhatFailsOutsideOfATestIsAFailure() =>
        AssertCounts(Run(Job(Report(Pass + "<system-err>the fixture</system-err>", errors: 1) + "; exit 2")), passed: 1, failed: 1);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ATestThatIsSkippedWithoutLeaveIsAFailure()
    {
        var run = Run(Job(Report(Pass + Skipped("no time today"))));
        AssertCounts(run, passed: 1, failed: 1, skipped: 1);
        Assert.Equal(["job: N.A.Skips is skipped, though it must run here: no time today"], run.Failures);
    }

    [Theory(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    [InlineData("for Windows", 0)]
    [InlineData("no time today", 1)]
    public void AScriptThatSkipsSaysWhyInItsLastLine(string reason, int failed) =>
        AssertCounts(Run(Job($"echo '{reason}'; echo; exit 77")), failed: failed, skipped: 1);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void TooMuchMemoryIsAFailure()
    {
        var run = Run(Job("python3 -c 'import time; a = bytearray(80_000_000); time.sleep(1)' || sleep 1") with { Megabytes = 1 });
        Assert.Contains("MB of memory; at most 1 MB are allowed", Assert.Single(run.Failures));
    }

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AJobWhoseProjectIsGoneIsAFailure() => Assert.Equal(["job: there is no tests/Gone"], Run(Job("true tests/Gone")).Failures);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AWaitingTestIsRunAgain()
    {
        var run = Run(Job(FailsOnce(Pass)));
        AssertCounts(run, passed: 1);
        Assert.Equal(["N.A.Fails(x: 1)"], run.FailedAtFirst);
    }

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AWaitingTestThatFailsAgainHasFailed() => AssertCounts(Run(Job(FailsOnce(Failing))), failed: 1);

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void AnotherTestIsNotRunAgain() => AssertCounts(Run(Job(FailsOnce(""))), failed: 1); // the test program finds none with the trait

    [Fact(Skip = Linux, SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ATestThatFailsAtFirstTwiceInARowHasFailed()
    {
        var run = Run(Job(FailsOnce(Pass)), failedBefore: "N.A.Fails(x: 1)");
        Assert.Equal(["job: N.A.Fails(x: 1) failed at first, as in the run before"], run.Failures);
    }

    private const string Pass = """<testcase name="N.A.Passes" classname="N.A" />""";
    private const string Failing = """<testcase name="N.A.Fails(x: 1)" classname="N.A"><failure message="1 is not 2">at N.A</failure></testcase>""";

    private static string Skipped(string reason) => $"""<testcase name="N.A.Skips" classname="N.A"><skipped>{reason}</skipped></testcase>""";

    private static string Suite(string program, string tests, int errors = 0) =>
        $"""<testsuites><testsuite name="{program}" errors="{errors}">{tests}</testsuite></testsuites>""";

    /// <summary>A command that writes a report as "dotnet test $REPORT" does.</summary>
    private static string Report(string tests, int errors = 0, string program = "/a/A.Tests.dll") =>
        $"set -- $REPORT; mkdir -p $2; echo '{Suite(program, tests, errors)}' >$2/a.xml";

    /// <summary>A command with a failing test, and beside it a test program that writes another report when it is asked for that test.</summary>
    private string FailsOnce(string again)
    {
        var program = folder.Write("A.Tests", $"""
            #!/usr/bin/env bash
            [[ "$*" = *"-method N.A.Fails -trait waits=yes"* ]] || exit 1
            echo '{Suite(folder["A.Tests.dll"], again)}' >"{"${@: -1}"}"
            """);
        if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(program, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        return Report(Failing, program: program + ".dll") + "; exit 2";
    }

    private static Job Job(string command) => new("job", command, 1) { Reports = command.Contains("$REPORT") ? 1 : 0 };

    private Run Run(Job job, params string[] failedBefore)
    {
        var allowed = new AllowedSkips(["always  : for Windows$"], (_, _) => true);
        var run = new Run(folder.Path, allowed, false, new Dictionary<string, string>(), printed.Add);
        run.Do([job], failedBefore);
        return run;
    }

    private static void AssertCounts(Run run, int passed = 0, int failed = 0, int skipped = 0) =>
        Assert.Equal((passed, failed, skipped), (run.Passed, run.Failed, run.Skipped));

    private static string Text(string file)
    {
        try
        {
            return File.ReadAllText(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return ""; // a process that has ended
        }
    }
}
