namespace RayCaster.Cli;

/// <summary>The picture files that a command line names.</summary>
internal static class InputFiles
{
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
            var found = isFolder ? Directory.GetFiles(operand, "*.png") : Matches(operand);
            Array.Sort(found, string.CompareOrdinal);
            foreach (var file in found)
            {
                if (!isFolder) chosen.Add(file);
                if (seen.Add(Path.GetFullPath(file))) files.Add(file);
            }
        }
        return files;
    }

    /// <summary>Keeps what is read from being replaced by what is made of it.</summary>
    /// <exception cref="ProblemException">The output is one of the inputs.</exception>
    public static void Keep(IEnumerable<string> inputs, string output)
    {
        foreach (var input in inputs)
            if (Path.GetFullPath(input) == Path.GetFullPath(output))
                throw new ProblemException($"raycaster: {output} is one of the pictures that are read\n  Choose another name with -o.");
    }

    /// <summary>The file of a name, or those of a pattern: not every shell resolves it.</summary>
    private static string[] Matches(string operand)
    {
        var name = Path.GetFileName(operand);
        if (File.Exists(operand) || !name.AsSpan().ContainsAny('*', '?')) return [operand];
        var folder = Path.GetDirectoryName(operand) is { Length: > 0 } path ? path : ".";
        if (Directory.Exists(folder) && Directory.GetFiles(folder, name) is { Length: > 0 } files)
            return folder == "." ? Array.ConvertAll(files, file => Path.GetFileName(file)) : files;
        throw new ProblemException($"raycaster: no file matches {operand}");
    }
}
