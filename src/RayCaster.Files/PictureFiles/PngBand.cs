using System.Buffers.Binary;
using System.IO.Compression;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayCaster.Files;

/// <summary>
/// Some lines of a PNG, filtered and compressed apart from the others, so that several bands can be compressed at once and are yet one
/// stream in the file. A band that is written serves again.
/// </summary>
/// <remarks>
/// A zlib stream (RFC 1950) is two bytes of header, blocks of compressed data (RFC 1951), and a checksum, Adler-32, of all that is
/// compressed. Streams become one when the first keeps its header, the last its last block, which says that it is the last, and the checksums
/// give way to that of all. A stream can be cut before its last block because it is flushed there, which ends it at a whole byte.
/// </remarks>
internal sealed class PngBand(int lineBytes, int mostLines) : IDisposable
{
    private const int HeaderBytes = 2, ChecksumBytes = 4;
    private const byte FilterUp = 2;

    /// <summary>About so much goes to the compressor in one call.</summary>
    private const int BytesAtOnce = 1 << 15;

    /// <summary>Level 2 of 9 takes a fraction of the default's time and hardly more room.</summary>
    private static readonly ZLibCompressionOptions options = new() { CompressionLevel = 2 };

    private readonly byte[] above = new byte[lineBytes];
    private readonly byte[] filtered = new byte[(1 + lineBytes) * Math.Min(mostLines, 1 + BytesAtOnce / lineBytes)];
    private readonly MemoryStream compressed = new();
    private byte[]? lines;
    private ZLibStream? compressor;
    private Task? task;
    private bool isFirst, isLast;
    private int collected, start, end;

    /// <summary>How many bytes of lines the band still takes.</summary>
    public int Room => lineBytes * mostLines - collected;

    /// <summary>The last of the lines that were collected.</summary>
    public ReadOnlySpan<byte> LastLine => lines.AsSpan(collected - lineBytes, lineBytes);

    /// <summary>Whether the work that <see cref="Start"/> began is done.</summary>
    public bool IsDone => task!.IsCompleted;

    /// <summary>The band's part of the file's compressed data.</summary>
    public ReadOnlySpan<byte> Data => compressed.GetBuffer().AsSpan(start..end);

    /// <summary>The checksum of the chunk IDAT with these data.</summary>
    public uint Crc { get; private set; }

    /// <summary>How many bytes were compressed.</summary>
    public long FilteredBytes { get; private set; }

    /// <summary>Their checksum.</summary>
    public uint Adler { get; private set; }

    /// <summary>Begins anew.</summary>
    /// <param name="lineAbove">The line above the band; zeros above the picture, or nothing for the same.</param>
    /// <param name="isFirst">Whether the band is the picture's first.</param>
    /// <param name="isLast">Whether it is the last.</param>
    public void Begin(ReadOnlySpan<byte> lineAbove, bool isFirst, bool isLast)
    {
        lineAbove.CopyTo(above);
        compressed.SetLength(0);
        compressor = new ZLibStream(compressed, options, leaveOpen: true);
        (this.isFirst, this.isLast) = (isFirst, isLast);
        (collected, FilteredBytes) = (0, 0);
    }

    /// <summary>Keeps lines for <see cref="Start"/>.</summary>
    public void Collect(ReadOnlySpan<byte> more)
    {
        lines ??= GC.AllocateUninitializedArray<byte>(lineBytes * mostLines);
        more.CopyTo(lines.AsSpan(collected));
        collected += more.Length;
    }

    /// <summary>Lets another thread compress what was collected, and end the band.</summary>
    public void Start() => task = Task.Run(() =>
    {
        Compress(lines.AsSpan(0, collected));
        End();
    });

    /// <summary>Waits until that is done, if it was begun.</summary>
    public void Wait() => task?.GetAwaiter().GetResult();

    /// <summary>Compresses lines at once.</summary>
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

    /// <summary>Waits until no other thread works for the band any more, and frees what the compressor holds.</summary>
    public void Dispose()
    {
        task?.ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing).GetAwaiter().GetResult();
        compressor?.Dispose();
    }

    /// <summary>a − b modulo 256, byte by byte.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // a picture is often written before the runtime would optimise by itself
    private static void Subtract(ReadOnlySpan<byte> a, ReadOnlySpan<byte> b, Span<byte> difference)
    {
        ref byte firstA = ref MemoryMarshal.GetReference(a), firstB = ref MemoryMarshal.GetReference(b);
        ref var first = ref MemoryMarshal.GetReference(difference);
        var i = 0;
        for (; i + Vector256<byte>.Count <= a.Length; i += Vector256<byte>.Count)
            (Vector256.LoadUnsafe(ref firstA, (nuint)i) - Vector256.LoadUnsafe(ref firstB, (nuint)i)).StoreUnsafe(ref first, (nuint)i);
        for (; i < a.Length; i++) difference[i] = (byte)(a[i] - b[i]);
    }
}
