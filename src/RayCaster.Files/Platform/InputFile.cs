namespace RayCaster.Files;

/// <summary>Opens and reads files that a user names. Problems do not name the file.</summary>
internal static class InputFile
{
    /// <param name="kind">What messages call such a file.</param>
    /// <param name="extension">An extension that may have been left out.</param>
    public static FileStream Open(string path, string kind, MissingFileHint? names = null, string extension = "")
    {
        MissingFileHint.ThrowIfImpossible(path);
        if (Directory.Exists(path)) throw new ProblemException($"it is a folder, not a {kind}");
        try
        {
            return new(path, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        }
        catch (Exception e) when (e is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new ProblemException($"file not found{(names ?? new()).Hint(path, extension)}", e);
        }
        catch (Exception e) when (ProblemException.IsCausedByFile(e))
        {
            throw ProblemException.From(e);
        }
    }

    /// <param name="remedy">What to do if it has more than <paramref name="most"/> bytes.</param>
    public static ArraySegment<byte> Read(string path, string kind, int most, string remedy = "")
    {
        using var file = Open(path, kind, extension: ".json");
        try
        {
            return ReadToEnd(file, kind, most, remedy);
        }
        catch (IOException e)
        {
            throw ProblemException.From(e);
        }
    }

    /// <summary>Reads the rest of a stream, which may be a pipe that never ends.</summary>
    public static ArraySegment<byte> ReadToEnd(Stream stream, string kind, int most, string remedy = "", ReadOnlySpan<byte> begun = default) =>
        TryReadToEnd(stream, most, out var all, begun) ? all
            : throw new ProblemException(FormattableString.Invariant($"the {kind} has more than {most:N0} bytes, which is the limit{remedy}"));

    /// <summary>Reads up to the end of the stream; false if there are more than <paramref name="most"/> bytes.</summary>
    /// <param name="begun">Bytes that were read before; they come first.</param>
    public static bool TryReadToEnd(Stream stream, long most, out ArraySegment<byte> all, ReadOnlySpan<byte> begun = default)
    {
        all = default;
        var known = stream.CanSeek ? begun.Length + stream.Length - stream.Position : 0;
        if (known > most) return false;
        var bytes = new MemoryStream((int)known);
        var piece = new byte[1 << 16];
        bytes.Write(begun);
        while (bytes.Length <= most && stream.Read(piece, 0, (int)Math.Min(piece.Length, most + 1 - bytes.Length)) is > 0 and var count)
            bytes.Write(piece, 0, count);
        all = new(bytes.GetBuffer(), 0, (int)bytes.Length);
        return bytes.Length <= most;
    }
}
