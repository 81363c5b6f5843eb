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
    /// <param name="screen">A folder with a program that opens files, as if there was a screen; null for no such program.</param>
    /// <param name="options">More options.</param>
    public static LiveProcess Start(
        string scene, int iteration = 0, string? home = null, string? screen = null, params string[] options)
    {
        var start = new ProcessStartInfo(Path.Combine(AppContext.BaseDirectory, "raycaster-live"), [scene, .. options])
        {
            RedirectStandardOutput = true,
        };
        if (screen is null) start.ArgumentList.Add("--no-browser");
        else (start.Environment["DISPLAY"], start.Environment["PATH"]) = (":0", $"{screen}:{start.Environment["PATH"]}");
        if (iteration > 0) start.Environment["DOTNET_WATCH_ITERATION"] = $"{iteration}";
        if (home is not null) start.Environment["HOME"] = start.Environment["XDG_DATA_HOME"] = start.Environment["LOCALAPPDATA"] = home;
        var process = Process.Start(start)!;
        var address = "";
        while (!address.StartsWith("http://", StringComparison.Ordinal))
            address = process.StandardOutput.ReadLine()?.Trim() ?? throw new InvalidOperationException("the program has ended");
        return new(process, address);
    }

    public int Id => process.Id;

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
