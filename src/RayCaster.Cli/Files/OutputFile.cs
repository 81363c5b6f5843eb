namespace RayCaster.Cli;

/// <summary>Where a command writes to: a file, which is complete or unchanged, or standard output. No file that the command reads is replaced.</summary>
internal sealed class OutputFile : IDisposable
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    private readonly AtomicFile? file; // null for standard output

    public OutputFile(string output)
    {
        if (output == StandardStreams.Name)
        {
            Stream = StandardStreams.OpenOutput();
            return;
        }
        if (FilePlace.Resolve(output) is { } place && read.Contains(place))
            throw new ProblemException($"{output} is one of the files that are read\n  Choose another name with -o.");
        file = new(output);
        Stream = file.Stream;
    }

    /// <summary>Takes the bytes. Its exceptions are the system's: <see cref="Failure"/> says them in words.</summary>
    public Stream Stream { get; }

    public ProblemException Failure(Exception e) => file?.Failure(e) ?? StandardStreams.OutputFailure(e);

    /// <summary>Puts a file in its place.</summary>
    public void Finish() => file?.Finish();

    /// <summary>Deletes a file that is not finished.</summary>
    public void Dispose() => ((IDisposable?)file ?? Stream).Dispose();

    /// <summary>Its name in messages.</summary>
    public static string NameOf(string output) => output == StandardStreams.Name ? "standard output" : output;

    /// <summary>Notes files that are read, from the command line or for the scene.</summary>
    public static void Protect(IEnumerable<string> files) =>
        read.UnionWith(files.Where(file => file != StandardStreams.Name).Select(FilePlace.Resolve).OfType<string>());

    public static void Write(string output, byte[] content)
    {
        using var file = new OutputFile(output);
        try
        {
            file.Stream.Write(content);
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw file.Failure(e);
        }
        file.Finish();
    }
}
