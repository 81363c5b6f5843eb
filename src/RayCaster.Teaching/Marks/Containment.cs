using static System.FormattableString;

namespace RayCaster.Teaching;

/// <summary>
/// The limits that the system enforces on a student's program without special rights. On Linux, <c>unshare</c> gives the program its own tree of
/// processes, which ends as a whole, no network, and its own view of the files; <c>prlimit</c> limits the size of its files and the number of its
/// processes; and <c>nice</c> lets the marking program run first.
/// </summary>
/// <param name="IsApart">Whether all its processes end with it, even those that left their parent, and whether it sees no files but those of its
/// <see cref="ProgramPlace"/> and the system's.</param>
/// <param name="HasLimits">Whether the system limits the size of its files and the number of its processes.</param>
internal sealed record Containment(bool IsApart, bool HasLimits)
{
    /// <summary>The system counts all threads of the user, not the processes of one program, so its limit is higher by this factor.</summary>
    private const int ThreadsPerProcess = 20;

    /// <summary>The .NET runtime keeps its code in a file in memory, and does not start below this limit.</summary>
    private const long LeastFileBytes = 64_000_000;

    /// <summary>
    /// The first process of the tree. It is a shell, because signals have another effect on the first process of a tree. It ends after the time
    /// limit, and the whole tree with it, even if the marking program was killed before. It makes a root folder in memory, mounts there what the
    /// program may see at the same paths, and takes from the program the rights to undo that. Its arguments: the time, a folder to mount the root
    /// at, the folder to run in, a letter (r: may be read; w: may be written, too) and a path for each mount, <c>--</c>, and the command.
    /// </summary>
    private const string First = """
        set -e
        root=$1 folder=$2
        shift 2
        mount -t tmpfs -o size=64m none "$root"
        show() {
            if [ -L "$2" ]; then
                mkdir -p "$(dirname "$root$2")"
                [ -e "$root$2" ] || ln -s "$(readlink "$2")" "$root$2"
                show "$1" "$(readlink -f "$2")"
                return
            fi
            if [ -d "$2" ]; then
                mkdir -p "$root$2"
            else
                mkdir -p "$(dirname "$root$2")"
                [ -e "$root$2" ] || : >"$root$2"
            fi
            mount --rbind "$2" "$root$2"
            [ "$1" = w ] || mount -o remount,bind,ro "$root$2" 2>/dev/null || mount -o remount,bind,ro,nosuid,nodev "$root$2" 2>/dev/null || :
        }
        while [ "$1" != -- ]; do
            [ ! -e "$2" ] || show "$1" "$2"
            shift 2
        done
        shift
        mkdir -p "$root/tmp" "$root/proc"
        mount -t proc none "$root/proc" 2>/dev/null || mount --rbind /proc "$root/proc"
        ln -s /proc/self/fd "$root/dev/fd"
        ! command -v ip >/dev/null || ip link set lo up 2>/dev/null || : # the runner of tests talks to them over the loopback address
        cd "$root"
        mkdir .old
        PATH=$PATH:/usr/sbin:/sbin pivot_root . .old
        cd "$folder"
        umount -l /.old
        rmdir /.old
        timeout --foreground -s KILL "$0" setpriv --bounding-set=-all --inh-caps=-all --no-new-privs "$@" || exit $?
        """;

    /// <summary>What each program may read: the installed programs with their libraries and settings, and harmless devices.</summary>
    private static readonly string[] system =
    [
        "/usr", "/bin", "/sbin", "/lib", "/lib32", "/lib64", "/opt", "/etc", "/nix", "/snap", "/sys/fs/cgroup",
        "/dev/null", "/dev/zero", "/dev/full", "/dev/random", "/dev/urandom",
    ];

    private static readonly Lazy<Containment> here = new(Find);

    /// <summary>No limits by the system.</summary>
    public static Containment None { get; } = new(false, false);

    /// <summary>The limits that this machine offers.</summary>
    public static Containment Here => here.Value;

    /// <summary>How many processes of a tree are not the student's: unshare, the shell and timeout.</summary>
    public int Helpers => IsApart ? 3 : 0;

    /// <summary>Why students' programs must not be run here, and how to go on; null if they may.</summary>
    public static string? Refusal(bool isRoot, bool isContainer) => !isRoot || isContainer ? null :
        "students' programs would run as root, and one of them could take the whole machine: run mark as another user, or in a container as " +
        "docs/teaching.md shows";

    /// <summary>Refuses to run students' programs in this process's place.</summary>
    /// <remarks>Docker, Podman and systemd leave these files in their containers.</remarks>
    /// <exception cref="ProblemException">It runs as root outside a container, or has no folder for temporary files.</exception>
    public static void ThrowIfUnfit()
    {
        var isRoot = !OperatingSystem.IsWindows() && Environment.IsPrivilegedProcess;
        if (Refusal(isRoot, new[] { "/.dockerenv", "/run/.containerenv", "/run/systemd/container" }.Any(File.Exists)) is { } refusal)
            throw new ProblemException(refusal);
        if (Path.GetTempPath() is var folder && !Directory.Exists(folder))
            throw new ProblemException($"there is no folder for temporary files, {folder}: make it, or let TMPDIR name another one");
    }

    /// <summary>The limits in words, for the teacher.</summary>
    /// <param name="network">Whether the rubric allows the network.</param>
    public string InWords(bool network) =>
        (IsApart ? "Students' programs see their own folder, the scene and installed programs, and none of your other files."
            : "Students' programs run with your rights: they can read and change all your files. Use a container (docs/teaching.md).") +
        $" Their time, output, memory{(HasLimits ? ", file sizes" : "")} and processes are limited" +
        (!IsApart ? "; some processes may go on after them, and they can use the network."
            : network ? "; the rubric allows the network." : "; they have no network.");

    /// <summary>The command, with the commands in front of it that set the limits.</summary>
    public IReadOnlyList<string> Wrap(IReadOnlyList<string> command, ProgramPlace place, ProgramLimits limits, TimeSpan time) =>
    [
        .. HasLimits ? LimitsOf(limits) : [],
        .. IsApart ? OwnTree(limits.Network, time, place) : [],
        .. command,
    ];

    private static string[] LimitsOf(ProgramLimits limits) =>
    [
        "nice", "-n", "10", "prlimit", "--core=0", Invariant($"--fsize={Math.Max(limits.OutputBytes, LeastFileBytes)}"),
        Invariant($"--nproc={ProcessTree.TaskCount() + ThreadsPerProcess * limits.Processes}"), "--",
    ];

    private static string[] OwnTree(bool network, TimeSpan time, ProgramPlace place) =>
    [
        "unshare", "--user", "--map-root-user", "--mount", "--pid", "--fork", "--kill-child", .. network ? [] : (string[])["--net"], "--",
        "sh", "-c", First, Invariant($"{time.TotalSeconds + 5:0.#}"), place.Root, place.Folder,
        .. system.Concat(ProgramFolders()).Concat(place.Readable).SelectMany(path => (string[])["r", path]),
        .. place.Writable.SelectMany(path => (string[])["w", path]),
        "--",
    ];

    /// <summary>The folders outside the system's in which installed programs are.</summary>
    private static IEnumerable<string> ProgramFolders() =>
        $"{Environment.GetEnvironmentVariable("PATH")}:{Environment.GetEnvironmentVariable("DOTNET_ROOT")}".Split(':')
            .Where(folder => Path.IsPathRooted(folder) && folder != "/" && !system.Any(above => $"{folder}/".StartsWith($"{above}/")));

    private static Containment Find()
    {
        if (!OperatingSystem.IsLinux()) return None;
        var limits = new ProgramLimits(TimeSpan.FromSeconds(20), default, 100_000, 1_000_000_000, 100, false);
        using var work = new WorkFolder();
        return new(Works(new(true, false)), Works(new(false, true)));

        bool Works(Containment one) => new ProgramRunner(one).Run(["true"], work.Place(work.Files), limits, limits.Time, default).IsDone;
    }
}
