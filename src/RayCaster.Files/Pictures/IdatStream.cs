namespace RayCaster.Files;

/// <summary>The compressed data of a PNG: the data of all its chunks IDAT as one stream, which can be read once.</summary>
internal sealed class IdatStream(PngChunkReader chunks) : Stream
{
    public override int Read(Span<byte> buffer)
    {
        while (chunks.Left == 0 || chunks.Type != "IDAT")
        {
            if (chunks.Type == "IEND") return 0;
            chunks.Skip();
            chunks.Next();
        }
        return chunks.Read(buffer);
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
}
