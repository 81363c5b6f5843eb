namespace RayCaster.Files;

/// <summary>The bytes of a mesh file, which need not fit into memory, and the errors that name a place in it.</summary>
/// <param name="stream">The file's bytes; it must be able to seek.</param>
/// <param name="blockSize">How many bytes are read at once, unless a line or row is longer.</param>
/// <param name="threads">How many blocks are read at the same time, at most.</param>
internal sealed class MeshSource(string path, Stream stream, int blockSize = MeshSource.UsualBlockSize, int threads = 1)
{
    /// <summary>Small enough for a core's own cache. A file that is no larger is read on the caller's thread.</summary>
    public const int UsualBlockSize = 1 << 20;

    /// <summary>The bytes of the file when it was opened.</summary>
    public long Length { get; } = stream.Length;

    public int BlockSize => blockSize;

    public int Threads => threads;

    /// <summary>Fills the buffer; any thread may call it.</summary>
    /// <exception cref="MeshFileException">The file cannot be read, or became shorter.</exception>
    public void Read(long offset, Span<byte> buffer)
    {
        try
        {
            lock (stream)
            {
                stream.Position = offset;
                stream.ReadExactly(buffer);
            }
        }
        catch (EndOfStreamException e)
        {
            throw new MeshFileException(path, "the file became shorter while it was read", inner: e);
        }
        catch (IOException e)
        {
            throw new MeshFileException(path, $"cannot be read: {e.Message}", inner: e);
        }
    }

    /// <summary>The place of the first byte, from a place on, that is neither blank nor 0; null if there is none.</summary>
    public long? FirstNotBlank(long from)
    {
        if (from >= Length) return null;
        var buffer = new byte[Math.Min(1 << 16, Length - from)];
        for (; from < Length; from += buffer.Length)
        {
            var bytes = buffer.AsSpan(0, (int)Math.Min(buffer.Length, Length - from));
            Read(from, bytes);
            if (bytes.IndexOfAnyExcept(" \t\r\n\v\f\0"u8) is >= 0 and var place) return from + place;
        }
        return null;
    }

    public MeshFileException Error(string reason) => new(path, reason);

    public MeshFileException ErrorAtByte(long offset, string reason) => new(path, reason, offset: offset);

    /// <summary>A mistake in a text part of the file. Lines are counted only here, so that readers need not count them.</summary>
    public MeshFileException ErrorAtLine(long offset, string reason) => new(path, reason, LineAt(offset));

    private int LineAt(long offset)
    {
        var buffer = new byte[UsualBlockSize + 1]; // one more: CR or CRLF?
        var line = 1;
        for (var start = 0L; start < offset; start += UsualBlockSize)
        {
            var bytes = buffer.AsSpan(0, (int)Math.Min(buffer.Length, Math.Min(offset + 1, Length) - start));
            Read(start, bytes);
            var counted = bytes[..(int)Math.Min(UsualBlockSize, offset - start)];
            line += counted.Count((byte)'\n') + counted.Count((byte)'\r') - bytes.Count("\r\n"u8);
        }
        return line;
    }
}
