namespace RayCaster.Files;

/// <summary>Suggests names for files that are missing. Only the first missing files get a hint: a scene may name thousands.</summary>
internal sealed class MissingFileHint
{
    /// <summary>In a larger folder only the first files are compared.</summary>
    private const int MaxFiles = 20_000;

    private const int MaxHints = 20;

    private int hints;

    public static void ThrowIfImpossible(string path)
    {
        if (path.Length > 0 && !path.Contains('\0')) return;
        throw new ProblemException($"'{path.Replace("\0", @"\x00")}' is no file name") { NamesFile = true };
    }

    /// <summary>The end of a message about a missing file: its full path, unless that was given, and a file with a similar name.</summary>
    /// <param name="extension">An extension that may have been left out.</param>
    public string Hint(string path, string extension = "")
    {
        var full = Path.GetFullPath(path);
        var sought = full == path.Replace('/', Path.DirectorySeparatorChar) ? "" : $"; looked for {PrintableText.From(full)}";
        if (++hints > MaxHints) return sought;
        try
        {
            var folder = Path.GetDirectoryName(full)!;
            if (!Directory.Exists(folder)) return $"{sought}; there is no folder {PrintableText.From(folder)}{FolderHint(folder)}";
            var names = NamesIn(folder, isFolder: false);
            var completed = Path.GetFileName(path) + extension;
            if (extension.Length > 0 && Array.IndexOf(names, completed) >= 0) return $"{sought}; did you mean \"{completed}\"?";
            return sought + Similar(Path.GetFileName(path), names);
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            return sought; // the folder cannot be listed
        }
    }

    private static string FolderHint(string folder)
    {
        while (Path.GetDirectoryName(folder) is { } parent && !Directory.Exists(parent)) folder = parent;
        return Similar(Path.GetFileName(folder), NamesIn(Path.GetDirectoryName(folder)!, isFolder: true));
    }

    private static string Similar(string name, string[] names) => Array.Find(names, other => Accents.AreEquivalent(name, other)) is { } same
        ? $"; the accents of \"{same}\" are encoded otherwise: copy the name from the folder" : Spelling.DidYouMean(name, names);

    private static string[] NamesIn(string folder, bool isFolder) =>
    [
        .. (isFolder ? Directory.EnumerateDirectories(folder) : Directory.EnumerateFiles(folder)).Take(MaxFiles)
            .Select(path => Path.GetFileName(path))
            .Where(name => PrintableText.From(name) == name && !name.Contains('\uFFFD')).Order(StringComparer.Ordinal),
    ];
}
