namespace RayCaster.Cli;

/// <summary>The files that a run reads: those that its command line names, and those that a scene names.</summary>
internal static class InputFiles
{
    private static readonly HashSet<string> read = [];

    /// <summary>Notes files that are read, so that no output takes the place of one of them.</summary>
    public static void Note(IEnumerable<string> files)
    {
        foreach (var file in files)
            if (file.Length > 0 && file != SceneInput.Standard)
                read.Add(PlaceOf(file));
    }

    /// <summary>Refuses an output that is one of the files that were read.</summary>
    /// <exception cref="ProblemException">So it is.</exception>
    public static void Keep(string output)
    {
        if (output.Length == 0 || !read.Contains(PlaceOf(output))) return;
        throw new ProblemException($"raycaster: {output} is one of the files that are read\n  Choose another name with -o.");
    }

    /// <summary>The full path of a file, through links between folders: where it lies, though it may be named in two ways.</summary>
    private static string PlaceOf(string file)
    {
        var path = Path.GetFullPath(file);
        var folder = Path.GetDirectoryName(path);
        return folder is null ? path : Path.Combine(Resolved(new(folder)), Path.GetFileName(path));
    }

    private static string Resolved(DirectoryInfo folder)
    {
        try
        {
            var real = folder.LinkTarget is null ? folder : folder.ResolveLinkTarget(returnFinalTarget: true) as DirectoryInfo ?? folder;
            return real.Parent is { } parent ? Path.Combine(Resolved(parent), real.Name) : real.FullName;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return folder.FullName; // links in a ring, or a folder that may not be looked into
        }
    }

    /// <summary>The files that operands name, each once.</summary>
    /// <param name="operands">Files, folders and patterns.</param>
    /// <param name="chosen">Those that somebody has named by more than their folder.</param>
    /// <exception cref="ProblemException">An operand names nothing.</exception>
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

    /// <summary>The file of a name, or those of a pattern: not every shell resolves it.</summary>
    private static string[] Matches(string operand)
    {
        var name = Path.GetFileName(operand);
        if (File.Exists(operand) || !name.AsSpan().ContainsAny('*', '?')) return [operand];
        var folder = Path.GetDirectoryName(operand) is { Length: > 0 } path ? path : ".";
        if (Directory.Exists(folder) && FilesIn(folder, name) is { Length: > 0 } files)
            return folder == "." ? Array.ConvertAll(files, file => Path.GetFileName(file)) : files;
        throw new ProblemException($"raycaster: no file matches {operand}");
    }

    /// <exception cref="ProblemException">The folder may not be listed, or a name in it is none for a message.</exception>
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
            throw new ProblemException($"raycaster: cannot list the folder {folder}: {(e is IOException ? e.Message : "you may not read it")}");
        }
    }
}
