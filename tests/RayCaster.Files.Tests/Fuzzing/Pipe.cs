namespace RayCaster.Files.Tests.Fuzzing;

/// <summary>A stream without a length that cannot seek, and comes in pieces of at most 100 bytes.</summary>
internal class Pipe(byte[] bytes) : ForwardStream
{
    /// <summary>How many bytes were read.</summary>
    public long Given { get; private set; }

    public override int Read(Span<byte> buffer)
    {
        var count = 0;
        for (; count < Math.Min(buffer.Length, 100) && ByteAt(Given) is { } value; Given++) buffer[count++] = value;
        return count;
    }

    /// <summary>The byte at a place; null at the end.</summary>
    protected virtual byte? ByteAt(long place) => place < bytes.Length ? bytes[place] : null;
}

/// <summary>Some bytes, and then a repetition without end.</summary>
internal sealed class EndlessPipe(string beginning, string again) : Pipe([])
{
    protected override byte? ByteAt(long place) =>
        (byte)(place < beginning.Length ? beginning[(int)place] : again[(int)((place - beginning.Length) % again.Length)]);
}
