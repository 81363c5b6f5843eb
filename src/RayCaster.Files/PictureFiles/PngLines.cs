using System.Buffers.Binary;

namespace RayCaster.Files;

/// <summary>The lines of a PNG, or of one of the passes of an interlaced one, brought to a byte a sample.</summary>
internal sealed class PngLines
{
    private readonly Stream data;
    private readonly PngHeader header;
    private readonly int margin;
    private readonly byte[] samples;
    private byte[] line, above;

    /// <summary>The checksum of all that was decompressed, the passes before this one included.</summary>
    public uint CheckSum { get; private set; }

    /// <param name="data">The decompressed data, from the first line of the pass on.</param>
    /// <param name="header">The picture.</param>
    /// <param name="pass">The pass.</param>
    /// <param name="checkSum">The checksum of what came before.</param>
    public PngLines(Stream data, PngHeader header, PngPass pass, uint checkSum)
    {
        CheckSum = checkSum;
        (this.data, this.header) = (data, header);
        var columns = pass.Columns(header.Width);
        // Filters look a whole pixel to the left, beyond the edge at zeros: these stand before each line. The byte before the line is
        // the number of its filter first, and a zero again when that is known.
        margin = Math.Max(1, header.BitsPerPixel / 8);
        (line, above) = (new byte[margin + header.LineBytes(columns)], new byte[margin + header.LineBytes(columns)]);
        samples = new byte[(long)columns * header.Channels];
    }

    /// <summary>The samples of the next line: places in the palette as they are, all others scaled to 8 bits. They hold until the line after it
    /// is read.</summary>
    /// <param name="y">Which line it is, for a message.</param>
    /// <exception cref="PictureFileException">The line is not there, or has no filter that is known.</exception>
    public ReadOnlySpan<byte> Next(int y)
    {
        (line, above) = (above, line);
        var filtered = line.AsSpan(margin - 1);
        if (data.ReadAtLeast(filtered, filtered.Length, throwOnEndOfStream: false) < filtered.Length)
            throw new PictureFileException($"the file is cut short: its data end in line {y} of {header.Height}");
        CheckSum = Adler32.Add(CheckSum, filtered);
        var filter = filtered[0];
        filtered[0] = 0;
        PngFilter.Undo(filter, line, above, margin);
        Unpack(line.AsSpan(margin));
        return samples;
    }

    /// <summary>Brings the samples of a line to a byte each, rounded to nearest.</summary>
    private void Unpack(ReadOnlySpan<byte> packed)
    {
        switch (header.BitDepth)
        {
            case 8:
                packed.CopyTo(samples);
                break;
            case 16:
                // v · 255 / 65535 is v / 257, which is never half a step.
                for (var i = 0; i < samples.Length; i++)
                    samples[i] = (byte)((BinaryPrimitives.ReadUInt16BigEndian(packed[(2 * i)..]) + 128) / 257);
                break;
            case var bits:
                var greatest = (1 << bits) - 1;
                var scale = header.ColorType == PngHeader.Palette ? 1 : 255 / greatest; // 255 is a multiple of 1, 3 and 15
                for (var i = 0; i < samples.Length; i++)
                {
                    var bit = (long)i * bits;
                    samples[i] = (byte)((packed[(int)(bit / 8)] >> (8 - bits - (int)(bit % 8)) & greatest) * scale);
                }
                break;
        }
    }
}
