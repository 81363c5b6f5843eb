namespace RayCaster.Files;

/// <summary>Reads all bytes of a file or stream, which may be a pipe that never ends.</summary>
internal static class InputBytes
{
    /// <summary>Reads a file in the form of a scene file.</summary>
    /// <param name="kind">What messages call such a file.</param>
    /// <param name="remedy">What to do if it has more than <paramref name="most"/> bytes.</param>
    /// <returns>Null if all was read; otherwise the reason why not.</returns>
    public static string? ReadFile(string path, string kind, int most, string remedy, out ArraySegment<byte> all)
    {
        all = default;
        if (path.Length == 0) return $"the name of the {kind} is empty";
        if (Directory.Exists(path)) return $"this is a folder, not a {kind}";
        if (!File.Exists(path)) return $"file not found{new FileNames().Hint(path, ".json")}";
        try
        {
            using var file = new FileStream(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
            return TryReadToEnd(file, most, out all) ? null : TooLong(kind, most, remedy);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            return $"the {kind} cannot be read: {e.Message}";
        }
    }

    public static string TooLong(string kind, int most, string remedy) =>
        FormattableString.Invariant($"the {kind} has more than {most:N0} bytes, which is the limit{remedy}");

    /// <summary>Reads up to the end of the stream; false if there are more than <paramref name="most"/> bytes.</summary>
    /// <param name="stream">The stream; if it can seek, its length is known.</param>
    /// <param name="begun">Bytes that were read before; they come first.</param>
    public static bool TryReadToEnd(Stream stream, long most, out ArraySegment<byte> all, ReadOnlySpan<byte> begun = default)
    {
        all = default;
        var known = stream.CanSeek ? begun.Length + stream.Length - stream.Position : 0;
        if (known > most) return false;
        var (bytes, piece) = (new MemoryStream((int)known), new byte[1 << 16]);
        bytes.Write(begun);
        while (bytes.Length <= most && stream.Read(piece) is > 0 and var count) bytes.Write(piece.AsSpan(0, count));
        all = new(bytes.GetBuffer(), 0, (int)bytes.Length);
        return bytes.Length <= most;
    }
}
