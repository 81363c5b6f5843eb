using System.Globalization;

namespace RayCaster;

/// <summary>
/// What keeps a student's program within bounds, as far as the system offers it without any rights: on Linux <c>unshare</c> gives it a tree of
/// processes of its own, which ends as a whole, and no network, and <c>prlimit</c> bounds the files that it writes. Neither hides other files.
/// </summary>
/// <param name="HasOwnTree">Whether all its processes end with it, however they have hidden.</param>
/// <param name="HasLimits">Whether the size of its files is bounded.</param>
internal sealed record Containment(bool HasOwnTree, bool HasLimits)
{
    private static readonly Lazy<Containment> here = new(Find);

    /// <summary>What there is on this machine.</summary>
    public static Containment Here => here.Value;

    /// <summary>In words, for the teacher.</summary>
    public string InWords =>
        !HasOwnTree && !HasLimits ? "limits of time, output and memory only"
        : $"limits of time, output and memory{(HasLimits ? ", of a file's size" : "")}{(HasOwnTree ? "; processes of their own, no network" : "")}";

    /// <summary>A command with what contains it before it.</summary>
    /// <param name="command">The command.</param>
    /// <param name="limits">What it may use.</param>
    public IReadOnlyList<string> Wrap(IReadOnlyList<string> command, ProgramLimits limits) =>
    [
        .. HasLimits ? (string[])["prlimit", "--core=0", string.Create(CultureInfo.InvariantCulture, $"--fsize={limits.OutputBytes}"), "--"] : [],
        // The shell is the tree's first process, to which signals mean something else than to any other.
        .. HasOwnTree ? (string[])[.. OwnTree(limits.Network), "sh", "-c", "\"$@\"; exit $?", "sh"] : [],
        .. command,
    ];

    private static string[] OwnTree(bool network) =>
        ["unshare", "--user", "--map-current-user", "--pid", "--fork", "--kill-child", .. network ? [] : (string[])["--net"], "--"];

    private static Containment Find()
    {
        if (!OperatingSystem.IsLinux()) return new(false, false);
        return new(Works([.. OwnTree(network: false), "true"]), Works(["prlimit", "--core=0", "--fsize=1000000", "--", "true"]));
    }

    private static bool Works(string[] command)
    {
        var limits = new ProgramLimits(TimeSpan.FromSeconds(5), default, 100_000, 1_000_000_000, 20, true);
        return new ProgramRunner(new(false, false)).Run(command, "/", limits, limits.Time, default).IsDone;
    }
}
