using System.Buffers.Binary;
using System.IO.Compression;

namespace RayCaster;

/// <summary>
/// PNG of every colour type, bit depth and interlacing (ISO/IEC 15948). Checksums are checked; alpha and transparency are dropped.
/// </summary>
internal static class PngReader
{
    /// <summary>Deflate describes 258 bytes with two bits at best.</summary>
    private const int MostBytesFromOne = 1032;

    /// <exception cref="PictureFileException">The file is damaged or too large.</exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        if (!file.StartsWith(PngChunk.Signature))
            throw new PictureFileException("it begins like a PNG, but its first eight bytes are damaged, as by a transfer as text");
        PngHeader? header = null;
        ReadOnlySpan<byte> palette = default;
        using var compressed = new MemoryStream();
        for (var at = PngChunk.Signature.Length; ;)
        {
            var data = ReadChunk(file, ref at, out var type);
            if (header is null && type != "IHDR") throw new PictureFileException($"its first chunk is {type} instead of IHDR");
            switch (type)
            {
                case "IHDR" when header is null:
                    header = PngHeader.Read(data);
                    break;
                case "PLTE":
                    palette = data;
                    break;
                case "IDAT":
                    compressed.Write(data);
                    break;
                case "IEND":
                    return Decompress(header!.Value, palette, compressed);
                default:
                    // A small first letter says that the picture can be shown without this chunk.
                    if (char.IsAsciiLetterUpper(type[0]))
                        throw new PictureFileException($"its chunk {type} is not known here or out of place");
                    break;
            }
        }
    }

    /// <summary>The data of the chunk at a place; the place moves on to the next one.</summary>
    private static ReadOnlySpan<byte> ReadChunk(ReadOnlySpan<byte> file, scoped ref int at, out string type)
    {
        var rest = file[at..];
        if (rest.Length < PngChunk.Frame)
            throw new PictureFileException($"the file is cut short: it ends at byte {file.Length:N0}, before its chunk IEND");
        var length = BinaryPrimitives.ReadUInt32BigEndian(rest);
        var follow = rest.Length - PngChunk.Frame;
        type = PictureFile.Printable(rest.Slice(4, 4));
        if (length > follow)
            throw new PictureFileException(
                $"the file is cut short: its chunk {type} at byte {at:N0} needs {length:N0} bytes, but {follow:N0} follow");
        var data = rest.Slice(8, (int)length);
        var crc = BinaryPrimitives.ReadUInt32BigEndian(rest[(8 + data.Length)..]);
        if (crc != PngChunk.Crc(0, rest.Slice(4, 4 + data.Length)))
            throw new PictureFileException($"its chunk {type} at byte {at:N0} is damaged: the checksum is wrong");
        at += PngChunk.Frame + data.Length;
        return data;
    }

    private static Picture Decompress(PngHeader header, ReadOnlySpan<byte> palette, MemoryStream compressed)
    {
        if (header.ColorType == PngHeader.Palette && (palette.Length % 3 != 0 || palette.Length / 3 is < 1 or > 256))
            throw new PictureFileException($"its palette has {palette.Length} bytes, but must be 1 to 256 colours of 3 bytes");
        if (header.DataBytes > (Int128)compressed.Length * MostBytesFromOne)
            throw new PictureFileException("the file is cut short: "
                + $"{header.Width:N0} × {header.Height:N0} pixels are {header.DataBytes:N0} bytes, "
                + $"which no compression brings down to the {compressed.Length:N0} that it holds");

        compressed.Position = 0;
        using var data = new ZLibStream(compressed, CompressionMode.Decompress, leaveOpen: true);
        var picture = new Picture(header.Width, header.Height);
        try
        {
            foreach (var pass in header.Passes) ReadPass(data, header, pass, palette, picture);
            // The end of the data brings their own checksum.
            if (data.ReadByte() >= 0) throw new PictureFileException("it holds more data than its pixels need");
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            throw new PictureFileException("its compressed data are damaged", e);
        }
        return picture;
    }

    private static void ReadPass(Stream data, PngHeader header, PngPass pass, ReadOnlySpan<byte> palette, Picture picture)
    {
        var columns = pass.Columns(header.Width);
        // Filters look a whole pixel to the left, beyond the edge at zeros: these stand before each line. The byte before the line is
        // the number of its filter first, and a zero again when that is known.
        var margin = Math.Max(1, header.BitsPerPixel / 8);
        var (line, above) = (new byte[margin + header.LineBytes(columns)], new byte[margin + header.LineBytes(columns)]);
        var samples = new byte[(long)columns * header.Channels];
        for (var y = pass.Y; y < header.Height; y += pass.StepY)
        {
            var filtered = line.AsSpan(margin - 1);
            if (data.ReadAtLeast(filtered, filtered.Length, throwOnEndOfStream: false) < filtered.Length)
                throw new PictureFileException($"the file is cut short: its data end in line {y} of {header.Height}");
            var filter = filtered[0];
            filtered[0] = 0;
            PngFilter.Undo(filter, line, above, margin);
            Unpack(line.AsSpan(margin), header, samples);
            Place(samples, y, header, pass, palette, picture);
            (line, above) = (above, line);
        }
    }

    /// <summary>Brings the samples of a line to a byte each: places in the palette as they are, all others scaled and rounded.</summary>
    private static void Unpack(ReadOnlySpan<byte> line, PngHeader header, Span<byte> samples)
    {
        switch (header.BitDepth)
        {
            case 8:
                line.CopyTo(samples);
                break;
            case 16:
                // v · 255 / 65535 is v / 257, which is never half a step.
                for (var i = 0; i < samples.Length; i++)
                    samples[i] = (byte)((BinaryPrimitives.ReadUInt16BigEndian(line[(2 * i)..]) + 128) / 257);
                break;
            case var bits:
                var greatest = (1 << bits) - 1;
                var scale = header.ColorType == PngHeader.Palette ? 1 : 255 / greatest; // 255 is a multiple of 1, 3 and 15
                for (var i = 0; i < samples.Length; i++)
                {
                    var bit = (long)i * bits;
                    samples[i] = (byte)((line[(int)(bit / 8)] >> (8 - bits - (int)(bit % 8)) & greatest) * scale);
                }
                break;
        }
    }

    /// <summary>Puts a line of a pass where it belongs in the picture.</summary>
    private static void Place(
        ReadOnlySpan<byte> samples, int y, PngHeader header, PngPass pass, ReadOnlySpan<byte> palette, Picture picture)
    {
        if (header.ColorType == PngHeader.Rgb && pass.StepX == 1)
        {
            samples.CopyTo(picture.Rgb.AsSpan(y * samples.Length)); // a whole line, as it is
            return;
        }
        for (var x = pass.X; x < picture.Width; x += pass.StepX, samples = samples[header.Channels..])
            picture[x, y] = ColorOf(samples, header, palette);
    }

    private static (byte R, byte G, byte B) ColorOf(ReadOnlySpan<byte> samples, PngHeader header, ReadOnlySpan<byte> palette)
    {
        switch (header.ColorType)
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
