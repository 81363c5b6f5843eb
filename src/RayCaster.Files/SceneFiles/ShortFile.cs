namespace RayCaster.Files;

/// <summary>Reads a short file in the form of a scene file: a camera's path or a rubric.</summary>
internal static class ShortFile
{
    /// <summary>Reads a file, which may be a pipe that never ends. Returns null if there is an error.</summary>
    /// <param name="path">The file; messages name it as it is given here.</param>
    /// <param name="name">The name of the outermost object in messages.</param>
    /// <param name="report">All errors and warnings, as text for people; empty if there are none.</param>
    public static T? Read<T>(string path, int mostBytes, string name, Func<SceneObject, T?> read, out string report) where T : class
    {
        if (!TryRead(path, mostBytes, out var utf8, out report)) return null;
        var result = SceneReader.Parse(utf8, path, "", name, read, out var document);
        report = new SceneReading(null, document.Problems()).Report();
        return result;
    }

    private static bool TryRead(string path, int mostBytes, out ReadOnlyMemory<byte> utf8, out string report)
    {
        (utf8, report) = (default, "");
        try
        {
            if (!File.Exists(path))
            {
                report = Directory.Exists(path) ? $"{path}: error: this is a folder; name a file\n"
                    : $"{path}: error: file not found{FileNames.Hint(path, ".json")}\n";
                return false;
            }
            using var file = File.OpenRead(path);
            if (StreamBytes.TryReadToEnd(file, mostBytes, out var bytes))
            {
                utf8 = bytes;
                return true;
            }
            report = FormattableString.Invariant($"{path}: error: the file is longer than {mostBytes:N0} bytes, which is the limit\n");
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            report = $"{path}: error: the file cannot be read: {e.Message}\n";
        }
        return false;
    }
}
