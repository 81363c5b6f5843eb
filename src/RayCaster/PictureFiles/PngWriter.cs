using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using System.Runtime.InteropServices;

namespace RayCaster;

/// <summary>
/// PNG, 8 bits each of red, green and blue. Each line is stored as its difference to the line above (the filter Up), since neighbours
/// in a column are often equal, and then compressed.
/// </summary>
internal sealed class PngWriter : PictureWriter
{
    private const int ChunkSize = 1 << 16;
    private const byte FilterUp = 2;

    /// <summary>Level 2 of 9 takes a fraction of the default's time and hardly more room.</summary>
    private static readonly ZLibCompressionOptions options = new() { CompressionLevel = 2 };

    private readonly MemoryStream compressed = new();
    private readonly ZLibStream compressor;
    private readonly byte[] lastLine, filtered;

    public PngWriter(Stream output, int width, int height) : base(output, width, height)
    {
        compressor = new ZLibStream(compressed, options, leaveOpen: true);
        lastLine = new byte[LineBytes];
        filtered = new byte[1 + LineBytes];
        filtered[0] = FilterUp;

        Span<byte> header = stackalloc byte[13];
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header[4..], height);
        header[8] = 8; // bits of a sample
        header[9] = 2; // red, green, blue
        header[10..].Clear(); // the only compression and filter method there are; not interlaced
        output.Write(PngChunk.Signature);
        PngChunk.Write(output, "IHDR"u8, header);
    }

    public override void Dispose()
    {
        compressor.Dispose();
        base.Dispose();
    }

    private protected override void Encode(ReadOnlySpan<byte> lines)
    {
        ReadOnlySpan<byte> above = lastLine;
        for (; !lines.IsEmpty; lines = lines[LineBytes..])
        {
            var line = lines[..LineBytes];
            Subtract(line, above, filtered.AsSpan(1));
            compressor.Write(filtered);
            if (compressed.Length >= ChunkSize) WriteCompressed();
            above = line;
        }
        above.CopyTo(lastLine);
    }

    private protected override void EncodeEnd()
    {
        compressor.Dispose();
        WriteCompressed();
        PngChunk.Write(Output, "IEND"u8, []);
    }

    private void WriteCompressed()
    {
        var data = compressed.GetBuffer().AsSpan(0, (int)compressed.Length);
        for (; data.Length > ChunkSize; data = data[ChunkSize..]) PngChunk.Write(Output, "IDAT"u8, data[..ChunkSize]);
        PngChunk.Write(Output, "IDAT"u8, data);
        compressed.SetLength(0);
    }

    /// <summary>a − b modulo 256, byte by byte.</summary>
    private static void Subtract(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b, Span<byte> difference)
    {
        var wideA = MemoryMarshal.Cast<byte, Vector<byte>>(a);
        var wideB = MemoryMarshal.Cast<byte, Vector<byte>>(b);
        var wideDifference = MemoryMarshal.Cast<byte, Vector<byte>>(difference);
        for (var i = 0; i < wideA.Length; i++) wideDifference[i] = wideA[i] - wideB[i];
        for (var i = wideA.Length * Vector<byte>.Count; i < a.Length; i++) difference[i] = (byte)(a[i] - b[i]);
    }
}
