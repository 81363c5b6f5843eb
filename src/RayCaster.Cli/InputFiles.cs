namespace RayCaster.Cli;

/// <summary>The files that a run reads, from the command line and from the scene.</summary>
internal static class InputFiles
{
    private static readonly HashSet<string> read = new( // where names of files may differ by case
        OperatingSystem.IsWindows() || OperatingSystem.IsMacOS() ? StringComparer.OrdinalIgnoreCase : StringComparer.Ordinal);

    /// <summary>Notes files that are read, so that no output replaces one.</summary>
    public static void Note(IEnumerable<string> files) => read.UnionWith(files.Where(file => file != SceneInput.Standard).Select(PlaceOf));

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
            return FilePlace.Of(file);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return Path.GetFullPath(file); // a circle of links, or a folder that may not be read
        }
    }

    /// <summary>The files that operands name, each once.</summary>
    /// <param name="chosen">The files that were named themselves, not only by their folder.</param>
    public static List<string> Of(IReadOnlyList<string> operands, out HashSet<string> chosen)
    {
        var (files, seen) = (new List<string>(), new HashSet<string>());
        chosen = [];
        foreach (var operand in operands)
        {
            var isFolder = Directory.Exists(operand);
            var found = isFolder ? FilesIn(operand, "*.png") : Matches(operand);
            Array.Sort(found, string.CompareOrdinal);
            foreach (var file in found)
            {
                if (!isFolder) chosen.Add(file);
                if (seen.Add(Path.GetFullPath(file))) files.Add(file);
            }
        }
        return files;
    }

    /// <summary>The file with a name, or the files of a pattern, which not every shell expands.</summary>
    private static string[] Matches(string operand)
    {
        var name = Path.GetFileName(operand);
        if (File.Exists(operand) || !name.AsSpan().ContainsAny('*', '?')) return [operand];
        var folder = Path.GetDirectoryName(operand) is { Length: > 0 } path ? path : ".";
        if (Directory.Exists(folder) && FilesIn(folder, name) is { Length: > 0 } files)
            return folder == "." ? Array.ConvertAll(files, file => Path.GetFileName(file)) : files;
        throw new ProblemException($"no file matches {operand}");
    }

    private static string[] FilesIn(string folder, string pattern)
    {
        try
        {
            var files = Directory.GetFiles(folder, pattern);
            foreach (var file in files) FileWord.Check(Path.GetFileName(file));
            return files;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            throw new ProblemException($"cannot list the folder {folder}: {(e is IOException ? e.Message : "you may not read it")}");
        }
    }
}
