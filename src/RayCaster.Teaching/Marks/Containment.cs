using static System.FormattableString;

namespace RayCaster.Teaching;

/// <summary>
/// The limits that the system enforces on a student's program without special rights. On Linux, <c>unshare</c> gives the program its own tree of
/// processes, which ends as a whole, and no network; <c>prlimit</c> limits the size of its files and the number of its processes; and <c>nice</c>
/// lets the marking program run first. None of them hides other files.
/// </summary>
/// <param name="HasOwnTree">Whether all its processes end with it, even those that left their parent.</param>
/// <param name="HasLimits">Whether the system limits the size of its files and the number of its processes.</param>
internal sealed record Containment(bool HasOwnTree, bool HasLimits)
{
    /// <summary>The system counts all threads of the user, not the processes of one program, so its limit is higher by this factor.</summary>
    private const int ThreadsPerProcess = 20;

    /// <summary>The .NET runtime keeps its code in a file in memory, and does not start below this limit.</summary>
    private const long LeastFileBytes = 64_000_000;

    /// <summary>
    /// The first process of the tree. It is a shell, because signals have another effect on the first process of a tree. It ends after the time
    /// limit, and the whole tree with it, even if the marking program was killed before.
    /// </summary>
    private const string First = "timeout --foreground -s KILL \"$0\" \"$@\"; exit $?";

    private static readonly Lazy<Containment> here = new(Find);

    /// <summary>No limits by the system.</summary>
    public static Containment None { get; } = new(false, false);

    /// <summary>The limits that this machine offers.</summary>
    public static Containment Here => here.Value;

    /// <summary>The limits in words, for the teacher.</summary>
    /// <param name="network">Whether the rubric allows the network.</param>
    public string InWords(bool network) =>
        $"Students' programs run with your rights. Their time, output, memory{(HasLimits ? ", file sizes" : "")} and processes are limited" +
        (!HasOwnTree ? "; some processes may go on after them, and they can use the network."
            : network ? "; the rubric allows the network." : "; they have no network.");

    /// <summary>The command, with the commands in front of it that set the limits.</summary>
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

        bool Works(Containment one) => new ProgramRunner(one).Run(["true"], "/", "/", limits, limits.Time, default).IsDone;
    }
}
