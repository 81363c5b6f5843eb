namespace RayCaster.Teaching;

/// <summary>
/// What keeps a student's program within bounds, as far as the system offers it without any rights: on Linux <c>unshare</c> gives it a tree of
/// processes of its own, which ends as a whole, and no network, <c>prlimit</c> bounds the files that it writes and the number of its processes, and
/// <c>nice</c> sees to it that whoever watches it gets a turn. None of them hides other files.
/// </summary>
/// <param name="HasOwnTree">Whether all its processes end with it, however they have hidden.</param>
/// <param name="HasLimits">Whether the size of its files is bounded, and the number of its processes by the system, too.</param>
internal sealed record Containment(bool HasOwnTree, bool HasLimits)
{
    /// <summary>The system counts threads, not processes, and all of the user's; a program of many threads is not yet too many processes.</summary>
    private const int ThreadsPerProcess = 20;

    /// <summary>The .NET runtime keeps its code in a file in memory and does not start with less.</summary>
    private const long LeastFileBytes = 64_000_000;

    /// <summary>
    /// The tree's first process, which is a shell since signals mean something else to that one than to any other. It ends after the time in any
    /// case, and all the tree with it, should nobody be left to end it.
    /// </summary>
    private const string First = "timeout --foreground -s KILL \"$0\" \"$@\"; exit $?";

    private static readonly Lazy<Containment> here = new(Find);

    /// <summary>Nothing but what every system has.</summary>
    public static Containment None { get; } = new(false, false);

    /// <summary>What there is on this machine.</summary>
    public static Containment Here => here.Value;

    /// <summary>In words, for the teacher.</summary>
    public string InWords =>
        !HasOwnTree && !HasLimits ? "limits of time, output, memory and processes only"
        : $"limits of time, output, memory and processes{(HasLimits ? ", of a file's size" : "")}" +
            $"{(HasOwnTree ? "; processes of their own, no network" : "")}";

    /// <summary>A command with what contains it before it.</summary>
    /// <param name="command">The command.</param>
    /// <param name="limits">What it may use.</param>
    /// <param name="time">How long it may take.</param>
    public IReadOnlyList<string> Wrap(IReadOnlyList<string> command, ProgramLimits limits, TimeSpan time) =>
    [
        .. HasLimits ? LimitsOf(limits) : [],
        .. HasOwnTree ? OwnTree(limits.Network, time) : [],
        .. command,
    ];

    private static string[] LimitsOf(ProgramLimits limits) =>
    [
        "nice", "-n", "10", "prlimit", "--core=0", Invariant($"--fsize={Math.Max(limits.OutputBytes, LeastFileBytes)}"),
        Invariant($"--nproc={ProcessTree.TaskCount() + ThreadsPerProcess * limits.Processes}"), "--",
    ];

    private static string[] OwnTree(bool network, TimeSpan time) =>
    [
        "unshare", "--user", "--map-current-user", "--pid", "--fork", "--kill-child", .. network ? [] : (string[])["--net"], "--",
        "sh", "-c", First, Invariant($"{time.TotalSeconds + 5:0.#}"),
    ];

    private static Containment Find()
    {
        if (!OperatingSystem.IsLinux()) return None;
        var limits = new ProgramLimits(TimeSpan.FromSeconds(20), default, 100_000, 1_000_000_000, 100, false);
        return new(Works(new(true, false)), Works(new(false, true)));

        bool Works(Containment one) => new ProgramRunner(one).Run(["true"], "/", limits, limits.Time, default).IsDone;
    }

    private static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
