namespace RayCaster.Benchmarks;

/// <summary>How much memory some work needs at most: what Linux counts as resident in the process.</summary>
internal static class PeakMemory
{
    private const string Status = "/proc/self/status", Reset = "/proc/self/clear_refs";

    /// <summary>Whether the system counts it.</summary>
    public static bool IsKnown => File.Exists(Reset);

    /// <summary>By how many bytes the process grows at most while the work runs, at least 100,000: the system counts pages.</summary>
    public static double Of(Action work)
    {
        GC.Collect(GC.MaxGeneration, GCCollectionMode.Aggressive, blocking: true, compacting: true); // gives free memory back to the system
        File.WriteAllText(Reset, "5"); // the highest count is the present one from now on
        var before = Kilobytes("VmRSS:");
        work();
        return Math.Max(1e5, 1024.0 * (Kilobytes("VmHWM:") - before));
    }

    private static long Kilobytes(string key) =>
        long.Parse(File.ReadLines(Status).First(line => line.StartsWith(key, StringComparison.Ordinal)).Split([' ', '\t'])[^2]);
}
