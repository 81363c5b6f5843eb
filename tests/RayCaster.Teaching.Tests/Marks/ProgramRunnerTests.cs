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
        new ProgramRunner(isContained ? Containment.Here : Containment.None)
            .Run(["sh", "-c", script], folder.Path, folder.Path, other ?? limits, (other ?? limits).Time, default);

    [Theory]
    [InlineData(true, true, true, ", file sizes and processes are limited; the rubric allows the network.")]
    [InlineData(true, true, false, ", file sizes and processes are limited; they have no network.")]
    [InlineData(true, false, false, " and processes are limited; they have no network.")]
    [InlineData(false, true, false, ", file sizes and processes are limited; some processes may go on after them, and they can use the network.")]
    public void TheLimitsAreTold(bool hasOwnTree, bool hasLimits, bool network, string end) => Assert.Equal(
        $"Students' programs run with your rights. Their time, output, memory{end}", new Containment(hasOwnTree, hasLimits).InWords(network));

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
    [SkippableTheory]
    [MemberData(nameof(Contained))]
    public void AProgramThatMultipliesIsEnded(bool isContained)
    {
        Skip.If(!OperatingSystem.IsLinux(), "elsewhere the number is not known");
        var run = Run(isContained,
            "b() { if [ $1 -gt 0 ]; then b $(($1-1)) & b $(($1-1)) & fi; sleep 20; }; b 7",
            limits with { Time = TimeSpan.FromMinutes(1) });
        Assert.Equal(ProgramEnd.TooManyProcesses, run.End);
    }

    [Fact]
    public void AProgramThatIsNotThereIsTold()
    {
        var run = new ProgramRunner(Containment.None).Run([folder["no such program"]], folder.Path, folder.Path, limits, limits.Time, default);
        Assert.Equal(ProgramEnd.NotStarted, run.End);
    }
}
