namespace RayCaster.Files;

/// <summary>Finds the file that somebody meant.</summary>
internal static class FileNames
{
    /// <summary>The end of a message about a file that is not there: where it was looked for, unless the path says so, and which file may be meant.</summary>
    /// <param name="path">The file that is not there.</param>
    /// <param name="extension">What somebody may have left out at its end.</param>
    public static string Hint(string path, string extension = "")
    {
        var full = Path.GetFullPath(path);
        var sought = full == path ? "" : $"; looked for {full}";
        try
        {
            var folder = Path.GetDirectoryName(full)!;
            if (!Directory.Exists(folder)) return $"{sought}; there is no folder {folder}";
            var names = Array.ConvertAll(Directory.GetFiles(folder), name => Path.GetFileName(name)!);
            Array.Sort(names, StringComparer.Ordinal);
            var completed = Path.GetFileName(path) + extension;
            if (extension.Length > 0 && Array.IndexOf(names, completed) >= 0) return $"{sought}; did you mean \"{completed}\"?";
            return sought + Spelling.DidYouMean(Path.GetFileName(path), names);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return sought; // a folder that may not be listed has no other hint to give
        }
    }
}
