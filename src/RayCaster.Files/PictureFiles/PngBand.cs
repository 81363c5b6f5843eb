using System.Buffers.Binary;
using System.IO.Compression;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>
/// Some lines of a PNG, filtered and compressed by themselves. Several bands can be compressed at the same time, and their data join to one
/// stream in the file. A band can be used again after it is written.
/// </summary>
/// <remarks>
/// A zlib stream (RFC 1950) has a header of two bytes, blocks of compressed data (RFC 1951), and an Adler-32 checksum of the data before
/// compression. Of the bands' streams, only the first keeps its header, only the last its final block, and one checksum of all data replaces
/// theirs. A stream can be cut before its final block because it is flushed there, which fills up its last byte.
/// </remarks>
internal sealed class PngBand(int lineBytes, int mostLines) : IDisposable
{
    private const int HeaderBytes = 2, ChecksumBytes = 4;
    private const byte FilterUp = 2;

    /// <summary>About how many bytes go to the compressor in one call.</summary>
    private const int BytesAtOnce = 1 << 15;

    /// <summary>Level 2 of 9 takes a fraction of the default's time and makes hardly larger files.</summary>
    private static readonly ZLibCompressionOptions options = new() { CompressionLevel = 2 };

    private readonly byte[] above = new byte[lineBytes];
    private readonly byte[] filtered = new byte[(1 + lineBytes) * Math.Min(mostLines, 1 + BytesAtOnce / lineBytes)];
    private readonly MemoryStream compressed = new();
    private byte[]? lines;
    private ZLibStream? compressor;
    private Task? task;
    private bool isFirst, isLast;
    private int collected, start, end;

    /// <summary>How many more bytes of lines the band can collect.</summary>
    public int Room => lineBytes * mostLines - collected;

    public ReadOnlySpan<byte> LastLine => lines.AsSpan(collected - lineBytes, lineBytes);

    /// <summary>Whether the work that <see cref="Start"/> began is done.</summary>
    public bool IsDone => task!.IsCompleted;

    /// <summary>The band's part of the file's compressed data.</summary>
    public ReadOnlySpan<byte> Data => compressed.GetBuffer().AsSpan(start..end);

    /// <summary>The checksum of a chunk IDAT with <see cref="Data"/>.</summary>
    public uint Crc { get; private set; }

    public long FilteredBytes { get; private set; }

    /// <summary>The checksum of the bytes that were compressed.</summary>
    public uint Adler { get; private set; }

    /// <summary>Empties the band.</summary>
    /// <param name="lineAbove">The line above the band; empty at the top of the picture.</param>
    public void Begin(ReadOnlySpan<byte> lineAbove, bool isFirst, bool isLast)
    {
        lineAbove.CopyTo(above);
        compressed.SetLength(0);
        compressor = new ZLibStream(compressed, options, leaveOpen: true);
        (this.isFirst, this.isLast) = (isFirst, isLast);
        (collected, FilteredBytes) = (0, 0);
    }

    /// <summary>Copies lines for <see cref="Start"/>.</summary>
    public void Collect(ReadOnlySpan<byte> more)
    {
        lines ??= GC.AllocateUninitializedArray<byte>(lineBytes * mostLines);
        more.CopyTo(lines.AsSpan(collected));
        collected += more.Length;
    }

    /// <summary>Compresses the collected lines on another thread, and ends the band.</summary>
    public void Start() => task = Task.Run(() =>
    {
        Compress(lines.AsSpan(0, collected));
        End();
    });

    public void Wait() => task?.GetAwaiter().GetResult();

    /// <summary>Compresses lines on this thread.</summary>
    public void Compress(ReadOnlySpan<byte> more)
    {
        ReadOnlySpan<byte> before = above;
        var used = 0;
        for (; !more.IsEmpty; more = more[lineBytes..])
        {
            var line = more[..lineBytes];
            filtered[used] = FilterUp;
            Subtract(line, before, filtered.AsSpan(used + 1));
            before = line;
            used += 1 + lineBytes;
            if (used < filtered.Length && more.Length > lineBytes) continue;
            compressor!.Write(filtered.AsSpan(0, used));
            FilteredBytes += used;
            used = 0;
        }
        before.CopyTo(above);
    }

    /// <summary>After the last line: completes <see cref="Data"/> and the checksums.</summary>
    public void End()
    {
        compressor!.Flush();
        var cut = (int)compressed.Length;
        compressor.Dispose();
        var stream = compressed.GetBuffer().AsSpan(0, (int)compressed.Length);
        Adler = BinaryPrimitives.ReadUInt32BigEndian(stream[^ChecksumBytes..]);
        (start, end) = (isFirst ? 0 : HeaderBytes, isLast ? stream.Length - ChecksumBytes : cut);
        Crc = PngChunk.Crc(PngChunk.Crc(0, "IDAT"u8), Data);
    }

    /// <summary>Waits until no other thread works for the band, and frees the compressor.</summary>
    public void Dispose()
    {
        task?.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing).GetAwaiter().GetResult();
        compressor?.Dispose();
    }

    /// <summary>a − b modulo 256, byte by byte.</summary>
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
