namespace RayCaster.Files;

/// <summary>Reads the bytes of a file in order, with a buffer.</summary>
internal sealed class PnmBytes
{
    private readonly byte[] buffer = new byte[1 << 16];
    private readonly Stream file;
    private int at, end;
    private long passed; // bytes that were in the buffer before

    public PnmBytes(ReadOnlySpan<byte> begun, Stream rest)
    {
        begun.CopyTo(buffer);
        (file, end) = (rest, begun.Length);
        Length = rest.CanSeek ? begun.Length + rest.Length - rest.Position : null;
    }

    /// <summary>How many bytes there are; null for a pipe or device.</summary>
    public long? Length { get; }

    public long Place => passed + at;

    /// <summary>Looks at the next byte without taking it; −1 at the end.</summary>
    public int Peek() => at < end || Fill() ? buffer[at] : -1;

    /// <summary>Takes the next byte; −1 at the end.</summary>
    public int Next() => at < end || Fill() ? buffer[at++] : -1;

    /// <summary>Reads some of the next bytes; an empty buffer is bypassed.</summary>
    /// <returns>How many; 0 at the end.</returns>
    public int Read(Span<byte> bytes)
    {
        if (at == end)
        {
            var read = file.Read(bytes);
            passed += read;
            return read;
        }
        var count = Math.Min(bytes.Length, end - at);
        buffer.AsSpan(at, count).CopyTo(bytes);
        at += count;
        return count;
    }

    private bool Fill()
    {
        passed += end;
        at = end = 0;
        end = file.Read(buffer);
        return end > 0;
    }
}
