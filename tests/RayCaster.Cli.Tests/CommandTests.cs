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

    private protected void WaitForTemporaryFile(Process process)
    {
        while (!raycaster.Files.Any(file => file.EndsWith(".tmp")) && !process.HasExited) Thread.Sleep(1);
    }
}
