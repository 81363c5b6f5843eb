namespace RayCaster.Cli;

/// <summary>The files that a run reads, from the command line and from the scene.</summary>
internal static class InputFiles
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    /// <summary>Notes files that are read, so that no output replaces one.</summary>
    public static void Note(IEnumerable<string> files) => read.UnionWith(files.Where(file => file != StandardStreams.Name).Select(PlaceOf));

    /// <summary>Refuses an output that is one of the files that were read.</summary>
    public static void ThrowIfInput(string output)
    {
        if (read.Contains(PlaceOf(output)))
            throw new ProblemException($"{output} is one of the files that are read\n  Choose another name with -o.");
    }

    /// <summary>The place to which a path leads: the same for all names of the file.</summary>
    private static string PlaceOf(string file)
    {
        try
        {
            return FilePlace.Resolve(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return Path.GetFullPath(file); // a circle of links, or a folder that may not be read
        }
    }
}
