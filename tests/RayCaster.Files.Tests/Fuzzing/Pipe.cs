namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>A stream without a length that cannot seek, and comes in pieces of at most 100 bytes.</summary>
internal class Pipe(byte[] bytes) : Stream
{
    /// <summary>How many bytes were read.</summary>
    public long Given { get; private set; }

    public override int Read(Span<byte> buffer)
    {
        var count = 0;
        for (; count < Math.Min(buffer.Length, 100) && ByteAt(Given) is { } value; Given++) buffer[count++] = value;
        return count;
    }

    public override bool CanRead => true;
    public override bool CanWrite => false;
    public override bool CanSeek => false;
    public override long Length => throw new NotSupportedException();
    public override long Position { get => throw new NotSupportedException(); set => throw new NotSupportedException(); }
    public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));
    public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    public override void Flush() { }
    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();
    public override void SetLength(long value) => throw new NotSupportedException();

    /// <summary>The byte at a place; null at the end.</summary>
    protected virtual byte? ByteAt(long place) => place < bytes.Length ? bytes[place] : null;
}

/// <summary>Some bytes, and then a repetition without end.</summary>
internal sealed class EndlessPipe(string beginning, string again) : Pipe([])
{
    protected override byte? ByteAt(long place) =>
        (byte)(place < beginning.Length ? beginning[(int)place] : again[(int)((place - beginning.Length) % again.Length)]);
}
