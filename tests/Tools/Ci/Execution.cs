using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Ci;

/// <summary>How a command ended.</summary>
/// <param name="ExitCode">Its exit code; null if its time was over and it was killed.</param>
/// <param name="Output">What it printed.</param>
/// <param name="Time">How long it took.</param>
/// <param name="ProcessorSeconds">The processor time of it and all that it waited for.</param>
/// <param name="PeakMegabytes">The greatest memory of one of its processes, asked for four times a second.</param>
/// <param name="PeakProgram">Which process that was.</param>
internal sealed record Execution(int? ExitCode, string[] Output, TimeSpan Time, double ProcessorSeconds, int PeakMegabytes, string PeakProgram)
{
    /// <summary>The end of a command that was not run.</summary>
    public static Execution None { get; } = new(0, [], default, 0, 0, "");

    private static readonly List<ProcessTree> running = [];

    /// <summary>Runs a command in a session of its own, so that it can be killed with all that it has started.</summary>
    /// <param name="command">A command for bash.</param>
    /// <param name="folder">Where its output is kept.</param>
    /// <param name="limit">How long it may take.</param>
    /// <param name="environment">Environment variables.</param>
    public static Execution Run(string command, string folder, TimeSpan limit, IEnumerable<KeyValuePair<string, string>> environment)
    {
        var (log, times) = (Path.Combine(folder, "output.txt"), Path.Combine(folder, "times.txt"));
        var start = new ProcessStartInfo("setsid", ["bash", "-c",
            """exec >"$0" 2>&1 </dev/null; trap 'times >"$1"' EXIT; bash -c "$2" """, log, times, command]);
        foreach (var (name, value) in environment) start.Environment[name] = value;
        var clock = Stopwatch.StartNew();
        using var process = Process.Start(start)!;
        var tree = new ProcessTree(process.Id);
        lock (running) running.Add(tree);
        try
        {
            while (!process.WaitForExit(250) && clock.Elapsed < limit) tree.Measure();
            int? code = process.HasExited ? process.ExitCode : null;
            if (code is null) tree.Kill();
            return new(code, File.Exists(log) ? File.ReadAllLines(log) : [], clock.Elapsed, Seconds(times), tree.PeakMegabytes, tree.PeakProgram);
        }
        finally
        {
            lock (running) running.Remove(tree);
        }
    }

    /// <summary>Kills whatever runs.</summary>
    public static void KillAll()
    {
        lock (running) running.ForEach(tree => tree.Kill());
    }

    /// <summary>From what bash prints: its own time, and in the second line that of its children: "0m1.234s 0m0.100s".</summary>
    private static double Seconds(string times) => !File.Exists(times) ? double.NaN : File.ReadAllLines(times).Skip(1)
        .SelectMany(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))
        .Select(time => time.TrimEnd('s').Split('m'))
        .Sum(parts => 60 * double.Parse(parts[0], CultureInfo.InvariantCulture) + double.Parse(parts[1], CultureInfo.InvariantCulture));
}
