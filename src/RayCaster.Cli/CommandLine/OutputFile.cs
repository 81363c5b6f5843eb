namespace RayCaster.Cli;

/// <summary>Where a command writes to: a file, which is complete or unchanged, or standard output. No file that it reads is replaced.</summary>
internal sealed class OutputFile : IDisposable
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    private readonly AtomicFile? file; // null for standard output
    private readonly Stream stream;

    public OutputFile(string output)
    {
        if (output == StandardStreams.Name)
        {
            stream = StandardStreams.OpenOutput();
            return;
        }
        if (PathResolver.Resolve(output) is { } place && read.Contains(place))
            throw new ProblemException($"{output} is one of the files that are read\n  Choose another name with -o.");
        file = new(output);
        stream = file.Stream;
    }

    public void Write(ReadOnlySpan<byte> bytes, Action<Stream, ReadOnlySpan<byte>> write)
    {
        try
        {
            write(stream, bytes);
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw file?.Failure(e) ??
                new($"cannot write to standard output: {(e is IOException ? e.Message : "it is closed")}", e) { NamesFile = true };
        }
    }

    public void Finish() => file?.Finish();

    public void Dispose() => ((IDisposable?)file ?? stream).Dispose();

    public static string NameOf(string output) => output == StandardStreams.Name ? "standard output" : output;

    /// <summary>Notes files that are read, from the command line or for the scene.</summary>
    public static void Protect(IEnumerable<string> files) =>
        read.UnionWith(files.Where(file => file != StandardStreams.Name).Select(PathResolver.Resolve).OfType<string>());

    public static void Write(string output, byte[] content)
    {
        using var file = new OutputFile(output);
        file.Write(content, (stream, bytes) => stream.Write(bytes));
        file.Finish();
    }
}
