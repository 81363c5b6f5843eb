namespace RayCaster.Teaching;

/// <summary>Reads files in whose place a stranger's program may have put a pipe, a device or a link.</summary>
internal static class RegularFile
{
    /// <summary>The content of a file; null if it is not there, is a link or a folder, cannot be read, or is larger than the limit.</summary>
    /// <remarks>A pipe or device has no length. It is not opened, since that may wait for ever; it counts as empty.</remarks>
    public static byte[]? Read(string path, long maxBytes)
    {
        try
        {
            var file = new FileInfo(path);
            if (!file.Exists || file.LinkTarget is not null || file.Length > maxBytes) return null;
            return file.Length == 0 ? [] : ReadAtMost(path, file.Length);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    /// <summary>The first bytes of a file, which may grow meanwhile.</summary>
    private static byte[] ReadAtMost(string path, long length)
    {
        using var stream = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        var bytes = new byte[length];
        return bytes[..stream.ReadAtLeast(bytes, bytes.Length, throwOnEndOfStream: false)];
    }
}
