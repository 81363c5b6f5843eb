namespace RayCaster.Files;

/// <summary>Writes PPM: a header, then the samples as bytes, or as text with at most five pixels in a line; each line of the picture begins a new
/// one.</summary>
internal sealed class PpmWriter : PictureWriter
{
    /// <summary>5 · "255 255 255 " is 60 characters; the format allows 70.</summary>
    private const int SamplesOnALine = 15;

    private readonly byte[]? text; // a line

    public PpmWriter(Stream output, int width, int height, bool isText) : base(output, width, height)
    {
        if (isText) text = new byte[4 * SamplesOnALine];
        output.Write(Encoding.ASCII.GetBytes($"{(isText ? "P3" : "P6")}\n{width} {height}\n255\n"));
    }

    private protected override void Encode(ReadOnlySpan<byte> lines)
    {
        if (text is null) Output.Write(lines);
        else
            for (; !lines.IsEmpty; lines = lines[LineBytes..])
                for (var start = 0; start < LineBytes; start += SamplesOnALine)
                    WriteLine(lines[start..Math.Min(start + SamplesOnALine, LineBytes)], text);
    }

    private void WriteLine(ReadOnlySpan<byte> samples, byte[] text)
    {
        var length = 0;
        foreach (var sample in samples)
        {
            sample.TryFormat(text.AsSpan(length), out var digits);
            length += digits;
            text[length++] = (byte)' ';
        }
        text[length - 1] = (byte)'\n';
        Output.Write(text.AsSpan(0, length));
    }
}
