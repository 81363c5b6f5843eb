namespace RayCaster.Files;

/// <summary>The bytes of a mesh file in order. Only a piece of them is in memory, so a file may have any size.</summary>
/// <param name="stream">The file's bytes; it must be able to seek.</param>
internal sealed class MeshSource(string path, Stream stream, int pieceSize = 1 << 20)
{
    private byte[] buffer = new byte[Math.Min(pieceSize, stream.Length + 1)];
    private int first, end; // the bytes that are loaded and not taken yet
    private long loaded;

    public long Length { get; } = stream.Length;

    /// <summary>The place of the next byte in the file.</summary>
    public long Position => loaded - (end - first);

    /// <summary>The next bytes, as many as are loaded; valid until more are loaded.</summary>
    public ReadOnlySpan<byte> Bytes => buffer.AsSpan(first, end - first);

    /// <summary>Loads more bytes; false at the end of the file.</summary>
    public bool Load()
    {
        if (loaded == Length) return false;
        if (end == buffer.Length) MakeRoom();
        var count = stream.Read(buffer.AsSpan(end, (int)Math.Min(buffer.Length - end, Length - loaded)));
        if (count == 0) throw Error("the file became shorter while it was read");
        end += count;
        loaded += count;
        return true;
    }

    /// <summary>Whether so many bytes follow; they are loaded then.</summary>
    public bool Has(int count)
    {
        while (end - first < count)
            if (!Load()) return false;
        return true;
    }

    public ReadOnlySpan<byte> Take(int count)
    {
        Has(count);
        first += count;
        return buffer.AsSpan(first - count, count);
    }

    public void Skip(long count)
    {
        for (; count > end - first; Load()) (count, first) = (count - (end - first), end);
        first += (int)count;
    }

    public void Restart()
    {
        stream.Position = 0;
        (first, end, loaded) = (0, 0, 0);
    }

    /// <summary>Refuses a text in UTF-16, and a file of another kind.</summary>
    /// <param name="own">What the name promises.</param>
    public void ThrowUnless(string own)
    {
        Has(FileSignature.Bytes);
        if (FileSignature.IsUtf16(Bytes)) throw ErrorAtLine(1, "the file is in UTF-16; save it as UTF-8");
        if (FileSignature.Recognize(Bytes) is { } kind && kind != own) throw Error($"it is {kind}, and not {own} as its name says");
    }

    public ProblemException Error(string reason, string place = "") => new($"{path}{place}: {reason}") { NamesFile = true };

    public ProblemException ErrorAtByte(long offset, string reason) => Error(reason, $"(byte {offset})");

    /// <summary>A mistake in a text. Lines count from 1 and end with LF, CRLF or CR.</summary>
    public ProblemException ErrorAtLine(int line, string reason) => Error(reason, $"({line})");

    private void MakeRoom()
    {
        if (first == 0 && end >= MeshFile.MaxBytesAtOnce)
            throw ErrorAtByte(Position, FormattableString.Invariant(
                $"a line or row begins here that has more than {MeshFile.MaxBytesAtOnce:N0} bytes, which is the limit"));
        var bytes = Bytes;
        if (first == 0) buffer = new byte[Math.Min(2L * end, MeshFile.MaxBytesAtOnce)];
        bytes.CopyTo(buffer);
        (first, end) = (0, bytes.Length);
    }
}
