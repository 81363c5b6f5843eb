using System.Diagnostics;

namespace RayCaster.Cli.Tests;

/// <summary>Tests that run the console app in a temporary folder.</summary>
[Trait("program", "yes")] // native.sh runs them with another one
public abstract class CommandTests : IDisposable
{
    private protected static readonly string Room = Path.Combine(RayCasterProcess.Scenes, "room.json");

    private protected readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

    /// <summary>Runs a command line that must be refused with a message, exit code 2 and no file.</summary>
    private protected void Refuses(string message, params string[] arguments)
    {
        string[] before = raycaster.Files;
        raycaster.Run(arguments);
        Assert.Equal((2, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.StartsWith("raycaster: " + message, raycaster.Error);
        Assert.Equal(before, raycaster.Files);
    }

    /// <summary>The words of a command line, with the room's file for ROOM.</summary>
    private protected static string[] Words(string arguments) => Array.ConvertAll(arguments.Split(' '), word => word == "ROOM" ? Room : word);

    private protected void WaitForTemporaryFile(Process process) =>
        WaitFor("a temporary file", process, () => raycaster.Files.Any(file => file.EndsWith(".tmp")));

    /// <summary>Waits, at most a minute, for what a process does.</summary>
    private protected void WaitFor(string what, Process process, Func<bool> isSeen)
    {
        var start = Stopwatch.GetTimestamp();
        while (!isSeen())
        {
            var hasEnded = process.WaitForExit(5);
            if (!hasEnded && Stopwatch.GetElapsedTime(start) < TimeSpan.FromMinutes(1)) continue;
            process.Kill();
            process.WaitForExit();
            Assert.Fail($"waited for {what}, but {(hasEnded ? $"the process has ended with {process.ExitCode}" : "a minute has passed")}; " +
                $"files: {string.Join(", ", raycaster.Files)}; standard error: {process.StandardError.ReadToEnd()}");
        }
    }
}
