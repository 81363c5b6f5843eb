namespace RayCaster.Cli;

/// <summary>Writes what a command makes: to a file, which is complete or unchanged, or to standard output. No file that the command reads is
/// replaced.</summary>
internal static class OutputFile
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    /// <summary>Its name in messages.</summary>
    public static string NameOf(string output) => output == StandardStreams.Name ? "standard output" : output;

    /// <summary>Notes files that are read, from the command line or for the scene.</summary>
    public static void Protect(IEnumerable<string> files) =>
        read.UnionWith(files.Where(file => file != StandardStreams.Name).Select(FilePlace.Resolve).OfType<string>());

    public static void Write(string output, Action<Stream> write)
    {
        if (output == StandardStreams.Name)
        {
            StandardStreams.WriteOutput(write);
            return;
        }
        if (FilePlace.Resolve(output) is { } place && read.Contains(place))
            throw new ProblemException($"{output} is one of the files that are read\n  Choose another name with -o.");
        AtomicFile.Write(output, write);
    }
}
