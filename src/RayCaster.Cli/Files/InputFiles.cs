namespace RayCaster.Cli;

/// <summary>The files that a run reads, from the command line and from the scene.</summary>
internal static class InputFiles
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    /// <summary>Notes files that are read, so that no output replaces one.</summary>
    public static void Note(IEnumerable<string> files) =>
        read.UnionWith(files.Where(file => file != StandardStreams.Name).Select(FilePlace.Resolve).OfType<string>());

    /// <summary>Refuses an output that is one of the files that were read.</summary>
    public static void ThrowIfInput(string output)
    {
        if (FilePlace.Resolve(output) is { } place && read.Contains(place))
            throw new ProblemException($"{output} is one of the files that are read\n  Choose another name with -o.");
    }
}
