using System.Diagnostics;

namespace RayCaster.Cli.Tests;

/// <summary>The console app in a temporary folder: in this process, or where a test depends on it, in one of its own.</summary>
internal sealed class RayCasterProcess : IDisposable
{
    /// <summary>Another console app that is to be tested, such as a native one (tests/Campaigns/native.sh), or null.</summary>
    private static readonly string? other = Environment.GetEnvironmentVariable("RAYCASTER_APP");

    /// <summary>The console app itself.</summary>
    public static readonly string App =
        other ?? Path.Combine(AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "raycaster.exe" : "raycaster");

    private readonly TemporaryFolder folder = new();

    /// <summary>The project's scenes.</summary>
    public static string Scenes { get; } = ProjectFolder.PathOf("scenes");

    /// <summary>Where the process runs.</summary>
    public string Folder => folder.Path;

    public int ExitCode { get; private set; }

    public byte[] Output { get; private set; } = [];

    public string OutputText => System.Text.Encoding.UTF8.GetString(Output);

    public string Error { get; private set; } = "";

    /// <summary>The names of the files and folders in it now.</summary>
    public string[] Files => [.. folder.Names];

    public string PathOf(string file) => folder[file];

    public RayCasterProcess Write(string file, string text)
    {
        folder.Write(file, text);
        return this;
    }

    public RayCasterProcess Run(params string[] arguments) => Run("", arguments);

    public RayCasterProcess Run(string input, string[] arguments)
    {
        if (other is not null || !SameProcess.IsPossible) return RunApart(input, arguments);
        var (exitCode, output, error) = SameProcess.Run(Folder, input, arguments);
        return Finish(exitCode, output, System.Text.Encoding.UTF8.GetString(error));
    }

    /// <summary>Runs the app as a process of its own, for what depends on that.</summary>
    public RayCasterProcess RunApart(string input, params string[] arguments)
    {
        using var process = Start(arguments);
        return Finish(process, input);
    }

    /// <summary>Runs a line of a shell, in which the app is called <c>raycaster</c>.</summary>
    public RayCasterProcess RunInShell(string line)
    {
        using var process = StartProgram("sh", "-c", $"raycaster() {{ '{App}' \"$@\"; }}; {line}");
        return Finish(process, "");
    }

    public Process Start(params string[] arguments) => StartProgram(App, arguments);

    /// <summary>Sends a signal as the shell's <c>kill</c> does, and returns the exit code.</summary>
    public static int Kill(Process process, string signal)
    {
        Send(process, signal);
        if (process.WaitForExit(TimeSpan.FromSeconds(20))) return process.ExitCode;
        process.Kill();
        throw new TimeoutException($"the process does not heed SIG{signal}");
    }

    public static void Send(Process process, string signal)
    {
        // The standard error of this process may be that of a run in another test, which must not read that there is no such process.
        using var kill = Process.Start(new ProcessStartInfo("kill", ["-" + signal, $"{process.Id}"]) { RedirectStandardError = true })!;
        kill.WaitForExit();
    }

    private RayCasterProcess Finish(Process process, string input)
    {
        process.StandardInput.Write(input);
        process.StandardInput.Close();
        var error = process.StandardError.ReadToEndAsync();
        using var output = new MemoryStream();
        process.StandardOutput.BaseStream.CopyTo(output);
        process.WaitForExit();
        return Finish(process.ExitCode, output.ToArray(), error.Result);
    }

    private RayCasterProcess Finish(int exitCode, byte[] output, string error)
    {
        (ExitCode, Output, Error) = (exitCode, output, error.ReplaceLineEndings("\n"));
        Assert.DoesNotContain("   at ", Error); // no stack trace, whatever happens
        return this;
    }

    private Process StartProgram(string program, params string[] arguments)
    {
        var start = new ProcessStartInfo(program, arguments)
        {
            WorkingDirectory = Folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment.Remove("RAYCASTER_TRACE");
        start.Environment["DOTNET_EnableDiagnostics"] = "0"; // no debugger's pipe beside those of a test
        return Process.Start(start)!;
    }

    public void Dispose() => folder.Dispose();
}
