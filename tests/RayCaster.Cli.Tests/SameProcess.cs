using System.Runtime.InteropServices;

namespace RayCaster.Cli.Tests;

/// <summary>
/// The console app in the tests' own process: with the arguments, the current folder and the standard streams of a process of its own, but
/// without the time that starting one takes, which is most of the time of a small command.
/// </summary>
internal static partial class SameProcess
{
    private static readonly Lock running = new(); // the current folder and the standard streams are those of the whole process

    /// <summary>Whether the system has descriptors that can be replaced.</summary>
    public static bool IsPossible => !OperatingSystem.IsWindows();

    /// <summary>Runs a command, and returns its exit code and what it wrote to standard output and standard error.</summary>
    public static (int ExitCode, byte[] Output, byte[] Error) Run(string folder, string input, string[] arguments)
    {
        using var streams = new TemporaryFolder();
        streams.Write("0", input);
        var exitCode = 0;
        In(folder, () =>
        {
            var saved = (int[])[Duplicate(0), Duplicate(1), Duplicate(2)];
            try
            {
                Replace(0, streams["0"], FileMode.Open, FileAccess.Read);
                Replace(1, streams["1"], FileMode.Create, FileAccess.Write);
                Replace(2, streams["2"], FileMode.Create, FileAccess.Write);
                exitCode = Program.Main(arguments);
            }
            finally
            {
                for (var i = 0; i < saved.Length; i++)
                {
                    Duplicate(saved[i], i);
                    Close(saved[i]);
                }
            }
        });
        return (exitCode, File.ReadAllBytes(streams["1"]), File.ReadAllBytes(streams["2"]));
    }

    /// <summary>Runs something in a folder, alone.</summary>
    public static void In(string folder, Action run)
    {
        lock (running)
        {
            var back = Environment.CurrentDirectory;
            Environment.CurrentDirectory = folder;
            try
            {
                run();
            }
            finally
            {
                Environment.CurrentDirectory = back;
            }
        }
    }

    private static void Replace(int descriptor, string path, FileMode mode, FileAccess access)
    {
        using var file = File.OpenHandle(path, mode, access);
        Duplicate((int)file.DangerousGetHandle(), descriptor);
    }

    [LibraryImport("libc", EntryPoint = "dup")]
    private static partial int Duplicate(int descriptor);

    [LibraryImport("libc", EntryPoint = "dup2")]
    private static partial int Duplicate(int descriptor, int target);

    [LibraryImport("libc", EntryPoint = "close")]
    private static partial int Close(int descriptor);
}
