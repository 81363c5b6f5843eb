namespace RayCaster.Files;

/// <summary>Reads a short file in the form of a scene file: a camera's path or a rubric.</summary>
internal static class ShortFile
{
    /// <summary>Reads all bytes of a file, which may be a pipe that never ends.</summary>
    /// <param name="path">The file; messages name it as it is given here.</param>
    /// <param name="report">The error, as text for people; empty if the file could be read.</param>
    public static bool TryRead(string path, int mostBytes, out ReadOnlyMemory<byte> utf8, out string report)
    {
        (utf8, report) = (default, "");
        try
        {
            if (!File.Exists(path))
            {
                report = $"{path}: error: file not found{FileNames.Hint(path, ".json")}\n";
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
