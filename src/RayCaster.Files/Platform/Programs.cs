using System.ComponentModel;
using System.Diagnostics;

namespace RayCaster.Files;

/// <summary>
/// Starts other programs, by their full paths. Given a name, the system would look in the current folder, too, in which anybody's file may lie.
/// </summary>
public static class Programs
{
    private const UnixFileMode AnyMayExecute = UnixFileMode.UserExecute | UnixFileMode.GroupExecute | UnixFileMode.OtherExecute;

    /// <summary>Runs a program of .NET to its end, with a pipe as its standard input: however this process ends, the system closes it.</summary>
    /// <param name="arguments">Its file, and what it gets.</param>
    internal static int Run(IEnumerable<string> arguments)
    {
        using var program = Start(new(PathOf("dotnet"), arguments) { RedirectStandardInput = true });
        program.WaitForExit();
        return program.ExitCode;
    }

    /// <summary>Builds a project of a clone, unless that is done.</summary>
    /// <param name="project">Its folder.</param>
    /// <returns>The folder with what was built.</returns>
    /// <exception cref="ProblemException">It does not build.</exception>
    public static string Build(string project)
    {
        using var build = Start(new(PathOf("dotnet"), ["build", project, "-c", "Release", "-v", "quiet", "-tl:off"])
        {
            RedirectStandardOutput = true, // even quietly it says that it has succeeded
            WorkingDirectory = project, // whose global.json says which SDK builds it: that of the current folder may name anybody's
        });
        var said = build.StandardOutput.ReadToEnd();
        build.WaitForExit();
        if (build.ExitCode == 0) return Path.Combine(project, "bin", "Release", "net10.0");
        throw new ProblemException($"{PrintableText.From(project)} does not build\n{said.Trim()}");
    }

    /// <summary>Opens a file in the program that the user has chosen for its kind; on Windows an address, too.</summary>
    internal static void Open(string file) => Start(OperatingSystem.IsWindows() ? new(file) { UseShellExecute = true }
        : new(PathOf(OperatingSystem.IsMacOS() ? "open" : "xdg-open"), [file]) { RedirectStandardError = true }).Dispose();

    /// <summary>The full path of a program: of this process's own if it has that name, otherwise of the first in a folder of PATH. Folders that
    /// count from the current one are left out.</summary>
    private static string PathOf(string name)
    {
        if (Environment.ProcessPath is { } own && Path.GetFileNameWithoutExtension(own) == name) return own;
        var file = OperatingSystem.IsWindows() ? $"{name}.exe" : name;
        return $"{Environment.GetEnvironmentVariable("PATH")}".Split(Path.PathSeparator).Where(Path.IsPathFullyQualified)
            .Select(folder => Path.Join(folder, file)).FirstOrDefault(IsProgram)
            ?? throw new ProblemException($"{name} is not in PATH: install it, or add its folder to PATH");
    }

    private static bool IsProgram(string file) =>
        File.Exists(file) && (OperatingSystem.IsWindows() || (File.GetUnixFileMode(file) & AnyMayExecute) != 0);

    private static Process Start(ProcessStartInfo start)
    {
        try
        {
            return Process.Start(start) ?? new(); // none of its own, if a browser that runs opens the page
        }
        catch (Win32Exception e)
        {
            throw new ProblemException($"{PrintableText.From(start.FileName)} cannot be started: {e.Message}", e);
        }
    }
}
