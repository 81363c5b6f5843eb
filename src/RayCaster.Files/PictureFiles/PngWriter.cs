using System.Buffers.Binary;
using System.Text;

namespace RayCaster.Files;

/// <summary>
/// Writes PNG with 8 bits each of red, green and blue. Each line is stored as its difference from the line above (the filter Up), because
/// neighbours in a column are often equal, and then compressed; large pictures in bands, several at the same time.
/// </summary>
/// <remarks>Only the caller's thread writes to the output, so that the caller gets the output's exceptions.</remarks>
internal sealed class PngWriter : PictureWriter
{
    /// <summary>Smaller pictures are compressed on the caller's thread: other threads would take longer to start.</summary>
    private const int BytesOfLarge = 1 << 24;

    /// <summary>Small enough for many bands in a large picture, and large enough that a new start of the compressor costs almost nothing.</summary>
    private const int BytesOfBand = 1 << 20;

    /// <summary>The most bands at a time. Then the oldest must be written before a new one starts.</summary>
    private static int MostBands => Environment.ProcessorCount + 1;

    private readonly int linesOfBand, bandCount;
    private readonly Queue<PngBand> started = [], written = [];

    private PngBand band; // the one that takes the next lines
    private int bandsBegun;
    private uint adler = Adler32.OfNothing;

    public PngWriter(Stream output, int width, int height, PartFacts? part = null) : base(output, width, height)
    {
        linesOfBand = (long)LineBytes * height <= BytesOfLarge ? height : Math.Max(1, BytesOfBand / LineBytes);
        bandCount = (height - 1) / linesOfBand + 1;
        band = NextBand([]);

        output.Write(PngChunk.Signature);
        PngChunk.Write(output, "IHDR"u8, new PngHeader(width, height, 8, PngHeader.Rgb, Interlaced: false).ToBytes());
        if (part is not null) PngChunk.Write(output, "tEXt"u8, Encoding.Latin1.GetBytes($"{PartFacts.Keyword}\0{part}"));
    }

    /// <summary>Waits until no other thread works for this writer, at most for the time of a band.</summary>
    public override void Dispose()
    {
        foreach (var other in started) other.Dispose();
        band.Dispose();
        base.Dispose();
    }

    private protected override void Encode(ReadOnlySpan<byte> lines)
    {
        if (bandCount == 1)
        {
            band.Compress(lines);
            return;
        }
        while (!lines.IsEmpty)
        {
            if (band.Room == 0) StartBand();
            var now = Math.Min(lines.Length, band.Room);
            band.Collect(lines[..now]);
            lines = lines[now..];
        }
    }

    private protected override void EncodeEnd()
    {
        if (bandCount == 1) band.End();
        else band.Start();
        started.Enqueue(band);
        WriteOldest(leave: 0);

        Span<byte> checksum = stackalloc byte[4];
        BinaryPrimitives.WriteUInt32BigEndian(checksum, adler);
        PngChunk.Write(Output, "IDAT"u8, checksum);
        PngChunk.Write(Output, "IEND"u8, []);
    }

    /// <summary>Starts to compress the full band, and begins the next.</summary>
    private void StartBand()
    {
        var full = band;
        full.Start();
        started.Enqueue(full);
        WriteOldest(leave: MostBands - 1);
        band = NextBand(full.LastLine);
    }

    private PngBand NextBand(ReadOnlySpan<byte> lineAbove)
    {
        if (!written.TryDequeue(out var next)) next = new(LineBytes, linesOfBand);
        next.Begin(lineAbove, isFirst: bandsBegun == 0, isLast: bandsBegun == bandCount - 1);
        bandsBegun++;
        return next;
    }

    /// <summary>Writes the oldest bands: those that are done, and more until only <paramref name="leave"/> are left.</summary>
    private void WriteOldest(int leave)
    {
        while (started.TryPeek(out var oldest) && (started.Count > leave || oldest.IsDone))
        {
            oldest.Wait();
            PngChunk.Write(Output, "IDAT"u8, oldest.Data, oldest.Crc);
            adler = Adler32.Join(adler, oldest.Adler, oldest.FilteredBytes);
            written.Enqueue(started.Dequeue());
        }
    }
}
