using System.IO.Compression;
using System.Numerics;
using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>
/// Writes PNG with 8 bits each of red, green and blue. Each line is stored as its difference from the line above (the filter Up), because
/// neighbours in a column are often equal, and then compressed.
/// </summary>
internal sealed class PngWriter : PictureWriter
{
    private const byte FilterUp = 2;

    /// <summary>About how many bytes go to the compressor in one call, and from how many compressed bytes on a chunk is written.</summary>
    private const int BytesAtOnce = 1 << 15, BytesOfChunk = 1 << 20;

    /// <summary>Level 2 of 9 takes a fraction of the default's time and makes hardly larger files.</summary>
    private static readonly ZLibCompressionOptions options = new() { CompressionLevel = 2 };

    private readonly byte[] above, filtered;
    private readonly MemoryStream compressed = new();
    private readonly ZLibStream compressor;
    private int used; // of the filtered bytes

    public PngWriter(Stream output, int width, int height, (string Keyword, string Value)? text) : base(output, width, height)
    {
        above = new byte[LineBytes];
        filtered = new byte[(1 + LineBytes) * Math.Min(height, 1 + BytesAtOnce / LineBytes)];
        compressor = new(compressed, options, leaveOpen: true);

        output.Write(PngChunk.Signature);
        var header = new byte[PngHeader.Bytes]; // compression, filter and interlace method stay 0
        BinaryPrimitives.WriteInt32BigEndian(header, width);
        BinaryPrimitives.WriteInt32BigEndian(header.AsSpan(4), height);
        (header[8], header[9]) = (8, PngHeader.Rgb);
        PngChunk.Write(output, "IHDR"u8, header);
        if (text is var (keyword, value)) PngChunk.Write(output, "tEXt"u8, Encoding.Latin1.GetBytes($"{keyword}\0{value}"));
    }

    public override void Dispose()
    {
        compressor.Dispose();
        base.Dispose();
    }

    private protected override void Encode(ReadOnlySpan<byte> lines)
    {
        for (; !lines.IsEmpty; lines = lines[LineBytes..])
        {
            var line = lines[..LineBytes];
            filtered[used] = FilterUp;
            Subtract(line, above, filtered.AsSpan(used + 1));
            line.CopyTo(above);
            used += 1 + LineBytes;
            if (used == filtered.Length) Compress();
        }
    }

    private protected override void EncodeEnd()
    {
        Compress();
        compressor.Dispose(); // ends the data with their checksum
        WriteChunk();
        PngChunk.Write(Output, "IEND"u8, []);
    }

    private void Compress()
    {
        compressor.Write(filtered.AsSpan(0, used));
        used = 0;
        if (compressed.Length >= BytesOfChunk) WriteChunk();
    }

    private void WriteChunk()
    {
        PngChunk.Write(Output, "IDAT"u8, compressed.GetBuffer().AsSpan(0, (int)compressed.Length));
        compressed.SetLength(0);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // a picture is often written before the runtime would optimise by itself
    private static void Subtract(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b, Span<byte> difference)
    {
        var wideA = MemoryMarshal.Cast<byte, Vector<byte>>(a);
        var wideB = MemoryMarshal.Cast<byte, Vector<byte>>(b);
        var wide = MemoryMarshal.Cast<byte, Vector<byte>>(difference);
        for (var i = 0; i < wideA.Length; i++) wide[i] = wideA[i] - wideB[i];
        for (var i = wideA.Length * Vector<byte>.Count; i < a.Length; i++) difference[i] = (byte)(a[i] - b[i]);
    }
}
