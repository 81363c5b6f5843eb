using System.Diagnostics;

namespace RayCaster.Live.Tests;

/// <summary>The program itself, started by its command line.</summary>
internal sealed class LiveProcess : IDisposable
{
    private readonly Process process;

    private LiveProcess(Process process, string address) => (this.process, Address) = (process, address);

    /// <summary>The page's address, which the program printed.</summary>
    public string Address { get; }

    /// <summary>Starts the program and waits for its address.</summary>
    /// <param name="scene">The scene file.</param>
    /// <param name="iteration">Which start by "dotnet watch" this is; 0 without "dotnet watch".</param>
    /// <param name="home">The home folder; the user's own if left out.</param>
    /// <param name="options">More options.</param>
    public static LiveProcess Start(string scene, int iteration = 0, string? home = null, params string[] options)
    {
        var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "raycaster-live"), [scene, "--no-browser", .. options])
        {
            RedirectStandardOutput = true,
        };
        if (iteration > 0) start.Environment["DOTNET_WATCH_ITERATION"] = $"{iteration}";
        if (home is not null) start.Environment["XDG_DATA_HOME"] = start.Environment["LOCALAPPDATA"] = home;
        var process = Process.Start(start)!;
        var address = "";
        while (!address.StartsWith("http://", StringComparison.Ordinal))
            address = process.StandardOutput.ReadLine()?.Trim() ?? throw new InvalidOperationException("the program has ended");
        return new(process, address);
    }

    /// <summary>Sends a signal as the shell's <c>kill</c> does.</summary>
    public void Send(string signal)
    {
        using var kill = Process.Start("kill", ["-" + signal, $"{process.Id}"]);
        kill.WaitForExit();
    }

    /// <summary>Waits for the end, and returns the exit code.</summary>
    public async Task<int> ExitCodeAsync()
    {
        await process.WaitForExitAsync(new CancellationTokenSource(TimeSpan.FromSeconds(60)).Token);
        return process.ExitCode;
    }

    public void Dispose()
    {
        process.Kill();
        process.WaitForExit();
        process.Dispose();
    }
}
