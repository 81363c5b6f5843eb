namespace RayCaster.Files;

/// <summary>Finds the file that somebody meant. Each folder is listed once, and few names are looked for in it: a scene may miss a thousand
/// files.</summary>
internal sealed class FileNames
{
    /// <summary>How many hints are given: as many problems of a scene as are printed.</summary>
    private const int MostHints = SceneReading.Printed;

    /// <summary>Of a folder with more files only so many are looked at.</summary>
    private const int MostFiles = 20_000;

    private readonly Dictionary<string, string[]> listings = [];
    private int hints;

    /// <summary>How many names of files were read from folders.</summary>
    public int NamesRead { get; private set; }

    /// <summary>The end of a message about a file that is not there: where it was looked for, unless the path says so, and which file may be
    /// meant.</summary>
    /// <param name="path">The file that is not there.</param>
    /// <param name="extension">What somebody may have left out at its end.</param>
    public static string Hint(string path, string extension = "") => new FileNames().HintFor(path, extension);

    /// <inheritdoc cref="Hint"/>
    public string HintFor(string path, string extension = "")
    {
        var full = Path.GetFullPath(path);
        var sought = full == path ? "" : $"; looked for {PrintableText.Of(full)}";
        if (++hints > MostHints) return sought;
        try
        {
            var folder = Path.GetDirectoryName(full)!;
            if (!Directory.Exists(folder)) return $"{sought}; there is no folder {PrintableText.Of(folder)}";
            if (!listings.TryGetValue(folder, out var names)) listings.Add(folder, names = NamesIn(folder));
            var completed = Path.GetFileName(path) + extension;
            if (extension.Length > 0 && Array.IndexOf(names, completed) >= 0) return $"{sought}; did you mean \"{completed}\"?";
            return sought + Spelling.DidYouMean(Path.GetFileName(path), names);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return sought; // a folder that may not be listed has no other hint to give
        }
    }

    /// <summary>The names in a folder, in order; without those that cannot stand in a message, which nobody has meant.</summary>
    private string[] NamesIn(string folder)
    {
        var names = new List<string>();
        foreach (var path in Directory.EnumerateFiles(folder).Take(MostFiles))
        {
            var name = Path.GetFileName(path);
            if (PrintableText.Of(name) == name && !name.Contains('\uFFFD')) names.Add(name);
        }
        NamesRead += names.Count;
        names.Sort(StringComparer.Ordinal);
        return [.. names];
    }
}
