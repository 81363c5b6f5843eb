namespace RayCaster.Cli;

/// <summary>The files that words such as "parts/*.png" name: the shells of Windows do not expand patterns.</summary>
internal static class Glob
{
    /// <summary>The files, each once; those of a pattern in the order of their names.</summary>
    /// <param name="words">Files, which need not exist, and patterns with <c>*</c> and <c>?</c> in their last part.</param>
    public static List<string> Expand(IReadOnlyList<string> words) => [.. words.SelectMany(FilesOf).DistinctBy(Path.GetFullPath)];

    public static string[] FilesIn(string folder, string pattern)
    {
        try
        {
            var files = Directory.GetFiles(folder, pattern);
            foreach (var file in files) CommandLine.RefuseInvisible(Path.GetFileName(file));
            Array.Sort(files, string.CompareOrdinal);
            return files;
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw new ProblemException($"cannot list the folder {folder}: {(e is IOException ? e.Message : "you may not read it")}");
        }
    }

    private static string[] FilesOf(string word)
    {
        var name = Path.GetFileName(word);
        if (File.Exists(word) || !name.AsSpan().ContainsAny('*', '?')) return [word];
        var folder = Path.GetDirectoryName(word) is { Length: > 0 } path ? path : ".";
        if (Directory.Exists(folder) && FilesIn(folder, name) is { Length: > 0 } files)
            return folder == "." ? Array.ConvertAll(files, file => Path.GetFileName(file)) : files;
        throw new ProblemException($"no file matches {word}");
    }
}
