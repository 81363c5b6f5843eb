using System.Buffers.Binary;
using System.Text;

namespace RayCaster.Files;

/// <summary>
/// PNG, 8 bits each of red, green and blue. Each line is stored as its difference to the line above (the filter Up), since neighbours
/// in a column are often equal, and then compressed: that of a large picture in bands, several at once.
/// </summary>
/// <remarks>Only the thread that brings the lines writes to the output, so that an error of the output meets it and nobody else.</remarks>
internal sealed class PngWriter : PictureWriter
{
    /// <summary>Smaller pictures are compressed as they come: it is done by the time that other threads are awake.</summary>
    private const int BytesOfLarge = 1 << 24;

    /// <summary>Many in a large picture, and each so large that the compressor's fresh start costs next to nothing.</summary>
    private const int BytesOfBand = 1 << 20;

    /// <summary>How many bands may be under way; the lines of a further one wait until the oldest is written.</summary>
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

    /// <summary>Waits, for a band's time at most, until no other thread works for this writer any more.</summary>
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

    /// <summary>Has the full band compressed, and begins the next.</summary>
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

    /// <summary>Writes the oldest bands: those that are done, and as many more as it takes to leave only some.</summary>
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
