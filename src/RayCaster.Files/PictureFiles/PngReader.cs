using System.IO.Compression;
using System.Text;

namespace RayCaster.Files;

/// <summary>
/// PNG of every colour type, bit depth and interlacing (ISO/IEC 15948). Checksums are checked; alpha and transparency are dropped. What is
/// not interlaced is also read line by line, in memory that does not grow with the number of lines.
/// </summary>
internal sealed class PngReader : IDisposable
{
    /// <summary>Deflate describes 258 bytes with two bits at best.</summary>
    private const int MostBytesFromOne = 1032;

    /// <summary>A longer text is none of ours.</summary>
    private const int MostText = 4096;

    private readonly PngChunkReader chunks;
    private readonly byte[] palette = [];
    private readonly long firstData;
    private ZLibStream? data;
    private PngData? compressed;
    private PngLines? lines;
    private int linesRead;

    /// <summary>Reads all chunks but the pixels.</summary>
    /// <param name="file">The file, which can seek; it is left open.</param>
    /// <param name="mostBytes">What the picture may have in memory, three bytes a pixel.</param>
    /// <exception cref="PictureFileException">The file is damaged or too large.</exception>
    public PngReader(Stream file, long mostBytes)
    {
        chunks = new(file);
        PngHeader? header = null;
        var (dataBytes, paletteBytes, before) = (0L, 0L, "");
        for (chunks.Next(); ; before = chunks.Type, chunks.Next())
        {
            if (header is null && chunks.Type != "IHDR") throw new PictureFileException($"its first chunk is {chunks.Type} instead of IHDR");
            switch (chunks.Type)
            {
                case "IHDR" when header is null && chunks.Left != PngHeader.Bytes:
                    throw new PictureFileException($"its chunk IHDR has {chunks.Left} bytes instead of {PngHeader.Bytes}");
                case "IHDR" when header is null:
                    header = PngHeader.Read(chunks.ReadUpTo(PngHeader.Bytes), mostBytes);
                    continue;
                case "PLTE" when firstData != 0:
                    throw new PictureFileException("its palette comes after its data");
                case "PLTE" when paletteBytes > 0:
                    throw new PictureFileException("it has two palettes");
                case "PLTE":
                    paletteBytes = chunks.Left;
                    palette = chunks.ReadUpTo(3 * 256);
                    break;
                case "IDAT" when firstData != 0 && before != "IDAT":
                    throw new PictureFileException("its chunks IDAT do not follow one another");
                case "IDAT":
                    if (firstData == 0) firstData = chunks.Place;
                    dataBytes += chunks.Left;
                    chunks.Skip();
                    continue;
                case "acTL":
                    IsAnimation = true;
                    break;
                case "tEXt" when chunks.Left <= MostText && PartText is null:
                    PartText = TextOf(chunks.ReadUpTo(MostText));
                    break;
                case "IEND":
                    break;
                default:
                    // A small first letter says that the picture can be shown without this chunk.
                    if (char.IsAsciiLetterUpper(chunks.Type[0]))
                        throw new PictureFileException($"its chunk {chunks.Type} is not known here or out of place");
                    break;
            }
            chunks.Check();
            if (chunks.Type == "IEND") break;
        }

        Header = header!.Value;
        if (Header.ColorType == PngHeader.Palette && (paletteBytes % 3 != 0 || paletteBytes / 3 is < 1 or > 256))
            throw new PictureFileException($"its palette has {paletteBytes} bytes, but must be 1 to 256 colours of 3 bytes");
        if (Header.DataBytes > (Int128)dataBytes * MostBytesFromOne)
            throw new PictureFileException("the file is cut short: "
                + $"{Header.Width:N0} × {Header.Height:N0} pixels are {Header.DataBytes:N0} bytes, "
                + $"which no compression brings down to the {dataBytes:N0} that it holds");
    }

    /// <summary>What the file says about its pixels.</summary>
    public PngHeader Header { get; }

    /// <summary>Whether it is the first picture of an animation (APNG).</summary>
    public bool IsAnimation { get; }

    /// <summary>What the file says of the picture that it is part of (<see cref="PartFacts"/>), or null.</summary>
    public string? PartText { get; }

    /// <summary>Reads a whole picture.</summary>
    /// <exception cref="PictureFileException">The file is damaged or too large.</exception>
    public static Picture Read(Stream file, long mostBytes)
    {
        using var reader = new PngReader(file, mostBytes);
        return reader.ReadPicture();
    }

    /// <summary>Reads all lines of a picture that is not interlaced for nothing but to see whether they can be read.</summary>
    /// <exception cref="PictureFileException">They cannot.</exception>
    public void CheckLines()
    {
        var line = new byte[3 * Header.Width];
        for (var y = 0; y < Header.Height; y++) ReadLine(line);
    }

    /// <summary>Reads the next line of a picture that is not interlaced; the last one brings the end of the data, which is checked.</summary>
    /// <param name="rgb">Takes three bytes a pixel.</param>
    /// <exception cref="PictureFileException">The data are damaged.</exception>
    public void ReadLine(Span<byte> rgb) => FromData(rgb, static (reader, rgb) =>
    {
        reader.lines ??= new(reader.OpenData(), reader.Header, reader.Header.Passes[0], Adler32.OfNothing);
        var samples = reader.lines.Next(reader.linesRead);
        if (reader.Header.ColorType == PngHeader.Rgb) samples.CopyTo(rgb);
        else
            for (; !rgb.IsEmpty; rgb = rgb[3..], samples = samples[reader.Header.Channels..])
                (rgb[0], rgb[1], rgb[2]) = reader.ColorOf(samples);
        if (++reader.linesRead == reader.Header.Height) reader.CheckEnd(reader.lines.CheckSum);
    });

    /// <summary>The pixels as they are compressed, a zlib stream; checksums are checked.</summary>
    public Stream OpenCompressed()
    {
        chunks.Return(firstData);
        return new PngData(chunks);
    }

    public void Dispose() => data?.Dispose();

    private Picture ReadPicture()
    {
        OpenData();
        var picture = new Picture(Header.Width, Header.Height);
        FromData(picture, static (reader, picture) =>
        {
            var checkSum = Adler32.OfNothing;
            foreach (var pass in reader.Header.Passes)
            {
                var lines = new PngLines(reader.data!, reader.Header, pass, checkSum);
                for (var y = pass.Y; y < picture.Height; y += pass.StepY) reader.Place(lines.Next(y), y, pass, picture);
                checkSum = lines.CheckSum;
            }
            reader.CheckEnd(checkSum);
        });
        return picture;
    }

    private ZLibStream OpenData()
    {
        chunks.Return(firstData);
        return data = new ZLibStream(compressed = new PngData(chunks), CompressionMode.Decompress);
    }

    /// <summary>What a text says of the part that the picture is; null where it is another one. A file may have a million of them.</summary>
    private static string? TextOf(ReadOnlySpan<byte> chunk)
    {
        var end = chunk.IndexOf((byte)0);
        if (end != PartFacts.Keyword.Length || chunk[(end + 1)..].Contains((byte)0)) return null;
        return Encoding.Latin1.GetString(chunk[..end]) == PartFacts.Keyword ? Encoding.Latin1.GetString(chunk[(end + 1)..]) : null;
    }

    /// <summary>
    /// The end of the data brings their own checksum, and what may follow in the file that of its chunk. The runtime refuses a wrong checksum,
    /// but not
    /// one that is cut off.
    /// </summary>
    private void CheckEnd(uint checkSum)
    {
        if (data!.ReadByte() >= 0) throw new PictureFileException("it holds more data than its pixels need");
        data.BaseStream.CopyTo(Stream.Null);
        if (compressed!.LastFour != checkSum) throw new PictureFileException("its compressed data do not end with their checksum");
    }

    /// <summary>Reads something from the data; what is wrong with them is the checksum's fault first.</summary>
    private void FromData<T>(T into, Action<PngReader, T> read) where T : allows ref struct
    {
        try
        {
            read(this, into);
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            chunks.Check();
            throw new PictureFileException("its compressed data are damaged", e);
        }
        catch (PictureFileException)
        {
            chunks.Check();
            throw;
        }
    }

    /// <summary>Puts a line of a pass where it belongs in the picture.</summary>
    private void Place(ReadOnlySpan<byte> samples, int y, PngPass pass, Picture picture)
    {
        if (Header.ColorType == PngHeader.Rgb && pass.StepX == 1)
        {
            samples.CopyTo(picture.Rgb.AsSpan(y * samples.Length)); // a whole line, as it is
            return;
        }
        for (var x = pass.X; x < picture.Width; x += pass.StepX, samples = samples[Header.Channels..]) picture[x, y] = ColorOf(samples);
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
                    throw new PictureFileException($"a pixel has colour {samples[0]} of a palette that has {palette.Length / 3}");
                return (palette[i], palette[i + 1], palette[i + 2]);
            default:
                return (samples[0], samples[1], samples[2]);
        }
    }
}
