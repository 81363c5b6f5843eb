using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Benchmarks;

/// <summary>Where figures come from.</summary>
internal static class Machine
{
    public static string Description => string.Join("; ", Parts);

    private static IEnumerable<string> Parts =>
    [
        Field("/proc/cpuinfo", "model name", ':') ?? "unknown processor",
        $"{Environment.ProcessorCount} cores as the system counts them",
        $"widest vectors of .NET {(Vector512.IsHardwareAccelerated ? 512 : Vector256.IsHardwareAccelerated ? 256 : 128)} bits",
        Field("/etc/os-release", "PRETTY_NAME", '=')?.Trim('"') ?? RuntimeInformation.OSDescription,
        RuntimeInformation.FrameworkDescription,
        $"{DateTime.UtcNow:yyyy-MM-dd}",
    ];

    private static string? Field(string file, string name, char separator)
    {
        if (!File.Exists(file)) return null;
        var line = File.ReadLines(file).FirstOrDefault(line => line.StartsWith(name, StringComparison.Ordinal));
        return line?[(line.IndexOf(separator) + 1)..].Trim();
    }
}
