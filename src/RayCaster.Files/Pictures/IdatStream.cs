namespace RayCaster.Files;

/// <summary>The compressed data of a PNG: the data of all its chunks IDAT as one stream, which can be read once.</summary>
internal sealed class IdatStream(PngChunkReader chunks) : ForwardStream
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
}
