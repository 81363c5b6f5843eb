namespace RayCaster.Cli;

internal static class StandardInput
{
    private const string Descriptors = "/proc/self/fd", Facts = "/proc/self/fdinfo";

    /// <summary>
    /// Whether the process was started without standard input. On Linux, the first file that the runtime opens then gets its number: a pipe for
    /// its own use, and a read from it would never return. Such a pipe is recognised by its other end, which this process has open for writing.
    /// </summary>
    public static bool IsClosed
    {
        get
        {
            if (!Directory.Exists(Descriptors)) return false; // not Linux
            if (TargetOf("0") is not { } input) return true;
            return Path.GetFileName(input).StartsWith("pipe:", StringComparison.Ordinal) && Directory.GetFileSystemEntries(Descriptors)
                .Select(descriptor => Path.GetFileName(descriptor)).Any(descriptor => TargetOf(descriptor) == input && IsForWriting(descriptor));
        }
    }

    /// <summary>What a descriptor leads to; null if it is closed.</summary>
    private static string? TargetOf(string descriptor) => new FileInfo(Path.Combine(Descriptors, descriptor)).LinkTarget;

    /// <summary>Whether the access mode, the last octal digit of a descriptor's flags, is "write only".</summary>
    private static bool IsForWriting(string descriptor) =>
        Array.Find(File.ReadAllLines(Path.Combine(Facts, descriptor)), line => line.StartsWith("flags:")) is { } flags && (flags[^1] & 3) == 1;
}
