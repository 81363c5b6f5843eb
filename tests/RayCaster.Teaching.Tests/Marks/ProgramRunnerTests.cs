using System.Diagnostics;

namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Programs that go too far, as scripts of a POSIX shell; each with what the machine has to contain it, and without.</summary>
public sealed class ProgramRunnerTests : IDisposable
{
    private static readonly ProgramLimits limits = new(TimeSpan.FromSeconds(0.5), default, 1_000_000, 500_000_000, 40, false);

    private readonly TemporaryFolder folder = new();

    public static TheoryData<bool> Contained => OperatingSystem.IsWindows() ? [] : [true, false];

    public void Dispose() => folder.Dispose();

    private ProgramRun Run(bool isContained, string script, ProgramLimits? other = null) =>
        Run(isContained ? Containment.Here : Containment.None, other ?? limits, "sh", "-c", script);

    private ProgramRun Run(Containment containment, ProgramLimits limits, params string[] command)
    {
        using var work = new WorkFolder();
        return new ProgramRunner(containment).Run(command, work.Place(folder.Path), limits, limits.Time, default);
    }

    [Theory]
    [InlineData(true, true, true, ", file sizes and processes are limited; the rubric allows the network.")]
    [InlineData(true, true, false, ", file sizes and processes are limited; they have no network.")]
    [InlineData(true, false, false, " and processes are limited; they have no network.")]
    [InlineData(false, true, false, ", file sizes and processes are limited; some processes may go on after them, and they can use the network.")]
    public void TheLimitsAreTold(bool isApart, bool hasLimits, bool network, string end)
    {
        var files = isApart ? "see their own folder, the scene and installed programs, and none of your other files."
            : "run with your rights: they can read and change all your files. Use a container (docs/teaching.md).";
        Assert.Equal($"Students' programs {files} Their time, output, memory{end}", new Containment(isApart, hasLimits).InWords(network));
    }

    [Theory]
    [InlineData(false, false, false)]
    [InlineData(true, true, false)]
    [InlineData(true, false, true)]
    public void RootRunsNoProgramsOutsideAContainer(bool isRoot, bool isContainer, bool isRefused) =>
        Assert.Equal(isRefused, Containment.Refusal(isRoot, isContainer)?.Contains("run mark as another user, or in a container") == true);

    /// <remarks>A program that prints its environment and crashes shows it on the student's page.</remarks>
    [Fact]
    public void OfTheEnvironmentOnlyWhatProgramsNeedAndTheRubricNamesIsLeft()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "has other variables");
        Environment.SetEnvironmentVariable("RAYCASTER_TEST_TOKEN", "secret");
        Environment.SetEnvironmentVariable("RAYCASTER_TEST_NAMED", "course");
        var generous = limits with { Time = TimeSpan.FromMinutes(1), Environment = ["RAYCASTER_TEST_NAMED"] };
        var names = Run(true, "env", generous).Printed.Split('\n').Select(line => line.Split('=')[0]);
        string[] expected = ["PATH", "HOME", "TMPDIR", "TMP", "TEMP", "USERPROFILE", "LANG", "RAYCASTER_TEST_NAMED", "RAYCASTER_SUBMISSION"];
        Assert.Empty(names.Where(name => !name.StartsWith("DOTNET_")).Except([.. expected, "PWD", "OLDPWD", "SHLVL", "_"])); // of the shell
        Assert.Contains("RAYCASTER_TEST_NAMED", names);
    }

    [Fact] // the shell, unshare and timeout were counted
    public void OnlyTheStudentsProcessesAreCounted()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "elsewhere the number is not known");
        var few = limits with { Time = TimeSpan.FromMinutes(1), Processes = 3 };
        Assert.Equal(ProgramEnd.Exited, Run(true, "sleep 0.7 & sleep 0.7; exit 0", few).End);
        Assert.Equal(ProgramEnd.TooManyProcesses, Run(true, "for i in 1 2 3 4; do sleep 20 & done; sleep 20", few).End);
    }

    [Fact]
    public void WhereFilesCanBeHiddenAProgramSeesItsOwnAndThoseThatItMayRead()
    {
        Assert.SkipWhen(!Containment.Here.IsApart, "not allowed here");
        using var others = new TemporaryFolder();
        var (secret, shared) = (others.Write("secret", "of another"), others.Write("shared file", "for all"));
        folder.Write("mine", "my own");
        using var work = new WorkFolder();
        var generous = limits with { Time = TimeSpan.FromMinutes(1) };
        var run = new ProgramRunner(Containment.Here).Run(
            ["sh", "-c", $"cat mine '{shared}' '{secret}'; echo x >>'{shared}'; echo new >mine; ls {MarksKey.File} ~/; umount '{shared}'"],
            work.Place(folder.Path, folder.Path, shared), generous, generous.Time, default);
        Assert.Contains("my ownfor all", run.Printed);
        Assert.DoesNotContain("of another", run.Printed);
        Assert.Equal(("for all", "new\n"), (File.ReadAllText(shared), File.ReadAllText(folder["mine"])));
        Assert.Contains("No such file", run.Printed);
    }

    [Fact]
    public void FoldersInOneAnotherAreDeletedHoweverDeepTheyAre()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        using var work = new WorkFolder();
        const string nested = // 2,105 in one another
            "p=$(printf 'd/%.0s' $(seq 420)); mkdir -p a/$p; for i in 2 3 4 5; do mkdir -p b/$p && mv a b/$p && mv b a || exit 1; done";
        var generous = limits with { Time = TimeSpan.FromMinutes(2) };
        Assert.Equal("", new ProgramRunner(Containment.None)
            .Run(["sh", "-c", nested], work.Place(work.Files), generous, generous.Time, default).Printed);
        work.Dispose();
        Assert.False(Directory.Exists(work.Files));
    }

    [Theory]
    [MemberData(nameof(Contained))]
    public void AnExitCodeAndWhatIsPrintedAreTold(bool isContained)
    {
        var generous = limits with { Time = TimeSpan.FromMinutes(1) };
        var run = Run(isContained, "echo so far; echo and no further >&2; exit 3", generous);
        Assert.Equal((ProgramEnd.Exited, 3), (run.End, run.ExitCode));
        Assert.Equal(["and no further", "so far"], run.Printed.Split('\n').Order()); // two pipes, either of which may be read first
    }

    [Theory]
    [MemberData(nameof(Contained))]
    public void ACharacterThatIsPrintedInTwoPiecesStaysOne(bool isContained)
    {
        var generous = limits with { Time = TimeSpan.FromMinutes(1) };
        Assert.Equal("Größe", Run(isContained, @"printf 'Gr\303'; sleep 0.3; printf '\266\303\237e'", generous).Printed);
    }

    [Theory]
    [MemberData(nameof(Contained))]
    public void AProgramThatNeverEndsIsEndedWithItsChildren(bool isContained)
    {
        var start = Stopwatch.GetTimestamp();
        // The first child ignores polite signals, and leaves a trace as long as it lives; the second leaves its parent.
        var run = Run(isContained, "(trap '' TERM HUP INT; while :; do echo >>alive; sleep 0.02; done) & " +
            "(trap '' HUP; setsid sleep 60 2>/dev/null) & sleep 100");
        Assert.Equal(ProgramEnd.OutOfTime, run.End);
        Assert.InRange(Stopwatch.GetElapsedTime(start).TotalSeconds, 0.45, 60);
        var trace = folder.Write("alive", "");
        Thread.Sleep(200);
        Assert.Equal("", File.ReadAllText(trace));
    }

    [Theory]
    [MemberData(nameof(Contained))]
    public void AProgramThatPrintsWithoutEndIsEnded(bool isContained) =>
        Assert.Equal(ProgramEnd.TooMuchOutput,
            Run(isContained, "while :; do echo aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa; done",
                limits with { Time = TimeSpan.FromMinutes(2) }).End);

    /// <remarks>It multiplies to 256 processes at most, which end by themselves, lest a test that fails take the machine with it.</remarks>
    [Theory]
    [MemberData(nameof(Contained))]
    public void AProgramThatMultipliesIsEnded(bool isContained)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "elsewhere the number is not known");
        var run = Run(isContained,
            "b() { if [ $1 -gt 0 ]; then b $(($1-1)) & b $(($1-1)) & fi; sleep 20; }; b 7",
            limits with { Time = TimeSpan.FromMinutes(1) });
        Assert.Equal(ProgramEnd.TooManyProcesses, run.End);
    }

    [Fact]
    public void AProgramThatIsNotThereIsTold()
    {
        Assert.Equal(ProgramEnd.NotStarted, Run(Containment.None, limits, folder["no such program"]).End);
    }
}
