namespace RayCaster;

/// <summary>Finds the file that somebody meant.</summary>
internal static class FileNames
{
    /// <summary>"; did you mean …?", or that the folder is missing, or nothing.</summary>
    public static string DidYouMean(string path)
    {
        try
        {
            var folder = Path.GetDirectoryName(Path.GetFullPath(path))!;
            if (!Directory.Exists(folder)) return $"; there is no folder {folder}";
            var names = Array.ConvertAll(Directory.GetFiles(folder), name => Path.GetFileName(name)!);
            Array.Sort(names, StringComparer.Ordinal);
            return Spelling.DidYouMean(Path.GetFileName(path), names);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return ""; // a folder that may not be listed has no hint to give
        }
    }
}
