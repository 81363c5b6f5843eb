using System.Diagnostics;

namespace RayCaster.Tests.Cli;

/// <summary>The console app, run as a real process in a folder of its own, which goes away with this.</summary>
internal sealed class RayCasterProcess : IDisposable
{
    private static readonly string App = Path.Combine(AppContext.BaseDirectory, OperatingSystem.IsWindows() ? "raycaster.exe" : "raycaster");

    /// <summary>The project's scenes.</summary>
    public static string Scenes { get; } = Path.Combine(Root(), "scenes");

    /// <summary>Where the process runs.</summary>
    public string Folder { get; } = Directory.CreateTempSubdirectory("raycaster-").FullName;

    public int ExitCode { get; private set; }

    public byte[] Output { get; private set; } = [];

    public string OutputText => System.Text.Encoding.UTF8.GetString(Output);

    public string Error { get; private set; } = "";

    /// <summary>The names of the files that are in the folder now.</summary>
    public string[] Files => [.. Directory.GetFiles(Folder).Select(path => Path.GetFileName(path)).Order()];

    public string PathOf(string file) => Path.Combine(Folder, file);

    public RayCasterProcess Write(string file, string text)
    {
        File.WriteAllText(PathOf(file), text);
        return this;
    }

    public RayCasterProcess Run(params string[] arguments) => Run("", arguments);

    public RayCasterProcess Run(string input, string[] arguments)
    {
        using var process = Start(arguments);
        process.StandardInput.Write(input);
        process.StandardInput.Close();
        var error = process.StandardError.ReadToEndAsync();
        using var output = new MemoryStream();
        process.StandardOutput.BaseStream.CopyTo(output);
        process.WaitForExit();
        (ExitCode, Output, Error) = (process.ExitCode, output.ToArray(), error.Result.ReplaceLineEndings("\n"));
        Assert.DoesNotContain("   at ", Error); // no stack trace, whatever happens
        return this;
    }

    /// <summary>Runs commands of a POSIX shell, in which $0 is the app.</summary>
    public void Shell(string commands)
    {
        using var shell = Process.Start(new ProcessStartInfo("/bin/sh", ["-c", commands, App]) { WorkingDirectory = Folder })!;
        shell.WaitForExit();
        Assert.Equal(0, shell.ExitCode);
    }

    public Process Start(params string[] arguments)
    {
        var start = new ProcessStartInfo(App, arguments)
        {
            WorkingDirectory = Folder,
            RedirectStandardInput = true,
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        start.Environment.Remove("RAYCASTER_TRACE");
        return Process.Start(start)!;
    }

    public void Dispose() => Directory.Delete(Folder, recursive: true);

    private static string Root()
    {
        var folder = AppContext.BaseDirectory;
        while (!File.Exists(Path.Combine(folder, "RayCaster.sln"))) folder = Path.GetDirectoryName(folder)!;
        return folder;
    }
}
