namespace RayCaster.Files;

/// <summary>Reads the lines of a PNG, pass by pass, with one byte for each sample.</summary>
internal sealed class PngScanlines(Stream data, PngHeader header)
{
    // The left neighbours of a line's first pixel are zeros, which stand before each line. The last of these bytes first receives the number of
    // the filter, and is set to zero again.
    private readonly int margin = Math.Max(1, header.BitsPerPixel / 8);
    private byte[] line = [], above = [], samples = [];

    public void Begin(PngPass pass)
    {
        var columns = pass.Columns(header.Width);
        (line, above) = (new byte[margin + header.LineBytes(columns)], new byte[margin + header.LineBytes(columns)]);
        samples = new byte[(long)columns * header.Channels];
    }

    /// <summary>The samples of the next line, scaled to 8 bits if they are not places in the palette. The next call overwrites them.</summary>
    public ReadOnlySpan<byte> Next()
    {
        (line, above) = (above, line);
        var filtered = line.AsSpan(margin - 1);
        data.ReadExactly(filtered);
        var filter = filtered[0];
        filtered[0] = 0;
        PngFilter.Undo(filter, line, above, margin);
        Unpack(line.AsSpan(margin));
        return samples;
    }

    private void Unpack(ReadOnlySpan<byte> packed)
    {
        switch (header.BitDepth)
        {
            case 8:
                packed.CopyTo(samples);
                break;
            case 16:
                // v · 255 / 65535 is v / 257; its fraction is never ½.
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
