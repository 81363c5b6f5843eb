using System.IO.Compression;

namespace RayCaster.Files;

/// <summary>
/// Reads PNG of every colour type, bit depth and interlacing (ISO/IEC 15948). Checks all checksums, and leaves alpha out of the colours. A picture
/// that is not interlaced can be read line by line, in memory that does not grow with the number of lines.
/// </summary>
internal sealed class PngReader
{
    /// <summary>The best compression there is: Deflate describes 258 bytes with two bits.</summary>
    private const int MaxBytesFromOne = 1032;

    /// <summary>Longer texts were not written by this program.</summary>
    private const int MaxText = 4096;

    private readonly PngChunkReader chunks;
    private readonly byte[] palette = [], transparency = []; // transparency: the alpha of the palette's first colours, or the colour of alpha 0
    private readonly long firstData;
    private int leastAlpha = 255;
    private long notOpaque; // pixels

    /// <summary>Reads all chunks but the pixels. The file must be able to seek, and is left open.</summary>
    public PngReader(Stream file, long maxBytes, Action<string>? warn = null, string keyword = "")
    {
        chunks = new(file);
        PngHeader? header = null;
        var dataBytes = 0L;
        var paletteBytes = 0L;
        var before = "";
        for (chunks.Next(); ; before = chunks.Type, chunks.Next())
        {
            if (header is null && chunks.Type != "IHDR") throw new ProblemException($"its first chunk is {chunks.Type} instead of IHDR");
            switch (chunks.Type)
            {
                case "IHDR" when header is null && chunks.Left != PngHeader.Bytes:
                    throw new ProblemException($"its chunk IHDR has {chunks.Left} bytes instead of {PngHeader.Bytes}");
                case "IHDR" when header is null:
                    header = PngHeader.Read(chunks.ReadUpTo(PngHeader.Bytes), maxBytes);
                    continue;
                case "PLTE" when firstData != 0:
                    throw new ProblemException("its palette comes after its data");
                case "PLTE" when paletteBytes > 0:
                    throw new ProblemException("it has two palettes");
                case "PLTE":
                    paletteBytes = chunks.Left;
                    palette = chunks.ReadUpTo(3 * 256);
                    break;
                case "tRNS" when header is not null && firstData == 0 && chunks.Left <= 256:
                    transparency = chunks.ReadUpTo(256);
                    break;
                case "IDAT" when firstData != 0 && before != "IDAT":
                    throw new ProblemException("its chunks IDAT do not follow one another");
                case "IDAT":
                    if (firstData == 0) firstData = chunks.Place;
                    dataBytes += chunks.Left;
                    chunks.Skip();
                    continue;
                case "tEXt" when chunks.Left <= MaxText && Text is null:
                    Text = Encoding.Latin1.GetString(chunks.ReadUpTo(MaxText)).Split('\0') is [var key, var text] && key == keyword ? text : null;
                    break;
                case "IEND":
                    break;
                default:
                    // A capital first letter says that the picture cannot be shown without this chunk.
                    if (char.IsAsciiLetterUpper(chunks.Type[0]))
                        throw new ProblemException($"its chunk {chunks.Type} is unknown or in the wrong place");
                    break;
            }
            chunks.Check();
            if (chunks.IsDamaged)
            {
                if (chunks.Type == "tEXt") Text = null;
                warn?.Invoke($"its chunk {chunks.Type} at byte {chunks.Place:N0} is damaged: the checksum is wrong; the pixels do not need it");
            }
            if (chunks.Type == "IEND") break;
        }

        Header = header!.Value;
        if (firstData == 0) throw new ProblemException("it has no pixels: there is no chunk IDAT");
        if (Header.ColorType == PngHeader.Palette && (paletteBytes % 3 != 0 || paletteBytes / 3 is < 1 or > 256))
            throw new ProblemException($"its palette has {paletteBytes} bytes, but must be 1 to 256 colours of 3 bytes");
        if (Header.DataBytes > (Int128)dataBytes * MaxBytesFromOne)
            throw new ProblemException("the file is cut short: "
                + $"{Header.Width:N0} × {Header.Height:N0} pixels are {Header.DataBytes:N0} bytes, "
                + $"which cannot be compressed to the {dataBytes:N0} that the file holds");
    }

    public PngHeader Header { get; }

    /// <summary>The file's first text under the keyword; null if there is none.</summary>
    public string? Text { get; }

    public static Picture Read(Stream file, long maxBytes, Action<string> warn)
    {
        var reader = new PngReader(file, maxBytes, warn);
        var picture = new Picture(reader.Header.Width, reader.Header.Height);
        reader.ReadLines(y => picture.Rgb.AsMemory(3 * picture.Width * y, 3 * picture.Width), _ => { });
        if (reader.notOpaque > 0)
            warn(FormattableString.Invariant($"its alpha is {reader.leastAlpha} instead of 255 in {reader.notOpaque:N0} of ") +
                FormattableString.Invariant($"{picture.Rgb.Length / 3:N0} pixels: a viewer shows what lies behind. Write 255, or no alpha"));
        return picture;
    }

    /// <summary>Reads all lines, three bytes for each pixel, and checks the end of the data.</summary>
    public void ReadLines(Action<ReadOnlySpan<byte>> take)
    {
        if (Header.Interlaced) throw new ProblemException("it is interlaced, so that its lines cannot be read one after another");
        var line = new byte[3 * Header.Width];
        ReadLines(_ => line, _ => take(line));
    }

    /// <param name="lineAt">The memory for the colours of a line.</param>
    /// <param name="isRead">Called after each line of a pass.</param>
    private void ReadLines(Func<int, Memory<byte>> lineAt, Action<int> isRead)
    {
        chunks.Return(firstData);
        using var data = new ZLibStream(new IdatStream(chunks), CompressionMode.Decompress);
        var lines = new PngScanlines(data, Header);
        foreach (var pass in Header.Passes)
        {
            lines.Begin(pass);
            for (var y = pass.Y; y < Header.Height; y += pass.StepY)
            {
                Decode(y, () =>
                {
                    var samples = lines.Next();
                    ReadLine(samples, pass, lineAt(y).Span);
                    if (Header.ColorType is 4 or 6 || transparency.Length > 0) CountAlpha(samples);
                });
                isRead(y);
            }
        }
        Decode(Header.Height - 1, () => CheckEnd(data));
    }

    private void ReadLine(ReadOnlySpan<byte> samples, PngPass pass, Span<byte> rgb)
    {
        if (Header.ColorType == PngHeader.Rgb && pass.StepX == 1) samples.CopyTo(rgb);
        else
            for (var at = 3 * pass.X; at < rgb.Length; at += 3 * pass.StepX, samples = samples[Header.Channels..])
                (rgb[at], rgb[at + 1], rgb[at + 2]) = ColorOf(samples);
    }

    private void CountAlpha(ReadOnlySpan<byte> samples)
    {
        for (; samples.Length > 0; samples = samples[Header.Channels..])
            if (AlphaOf(samples) is < 255 and var alpha)
                (leastAlpha, notOpaque) = (Math.Min(leastAlpha, alpha), notOpaque + 1);
    }

    private int AlphaOf(ReadOnlySpan<byte> samples) => Header.ColorType switch
    {
        4 or 6 => samples[Header.Channels - 1],
        PngHeader.Palette => samples[0] < transparency.Length ? transparency[samples[0]] : 255,
        _ => Header.BitDepth == 8 && IsTransparent(samples) ? 0 : 255, // of colours of other depths, as few files have, nothing is told
    };

    /// <summary>Whether it is the colour of alpha 0, which a picture without an alpha may name: two bytes for each sample.</summary>
    private bool IsTransparent(ReadOnlySpan<byte> samples)
    {
        var isSame = transparency.Length == 2 * Header.Channels;
        for (var i = 0; isSame && i < Header.Channels; i++) isSame = transparency[2 * i + 1] == samples[i];
        return isSame;
    }

    /// <summary>Damaged data are reported as a wrong checksum of their chunk, if it is wrong.</summary>
    private void Decode(int y, Action decode)
    {
        try
        {
            decode();
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            var isCut = e is EndOfStreamException || chunks.Type == "IEND";
            chunks.Check();
            throw new ProblemException(
                isCut ? $"the file is cut short: its data end in line {y} of {Header.Height}" : "its compressed data are damaged", e);
        }
        catch (ProblemException)
        {
            chunks.Check();
            throw;
        }
    }

    /// <summary>Checks that the data end here, with the right checksum. The runtime refuses a missing one only with its switch UseStrictValidation
    /// (Directory.Build.props). Bytes behind it are ignored, as PNG's third edition asks (11.2.3): programs write their whole buffer. The
    /// checksums of their chunks are checked.</summary>
    private static void CheckEnd(ZLibStream data)
    {
        try
        {
            if (data.ReadByte() >= 0) throw new ProblemException("it holds more data than its pixels need");
            data.BaseStream.CopyTo(Stream.Null);
        }
        catch (InvalidDataException e)
        {
            throw new ProblemException("its compressed data do not end with their checksum", e);
        }
    }

    private (byte R, byte G, byte B) ColorOf(ReadOnlySpan<byte> samples)
    {
        switch (Header.ColorType)
        {
            case 0 or 4:
                return (samples[0], samples[0], samples[0]);
            case PngHeader.Palette:
                var i = 3 * samples[0];
                if (i >= palette.Length)
                    throw new ProblemException($"a pixel has colour {samples[0]} of a palette that has {palette.Length / 3}");
                return (palette[i], palette[i + 1], palette[i + 2]);
            default:
                return (samples[0], samples[1], samples[2]);
        }
    }
}
