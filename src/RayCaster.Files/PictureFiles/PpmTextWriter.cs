namespace RayCaster.Files;

/// <summary>Writes PPM in text: at most five pixels in a line of text; each line of the picture begins a new one.</summary>
internal sealed class PpmTextWriter : PictureWriter
{
    /// <summary>5 · "255 255 255 " is 60 characters; the format allows 70.</summary>
    private const int SamplesOnALine = 15;

    private readonly byte[] text;

    public PpmTextWriter(Stream output, int width, int height) : base(output, width, height)
    {
        text = new byte[4 * SamplesOnALine];
        output.Write(Encoding.ASCII.GetBytes($"P3\n{width} {height}\n255\n"));
    }

    private protected override void Encode(ReadOnlySpan<byte> lines)
    {
        for (; !lines.IsEmpty; lines = lines[LineBytes..])
            for (var start = 0; start < LineBytes; start += SamplesOnALine)
                WriteLine(lines[start..Math.Min(start + SamplesOnALine, LineBytes)]);
    }

    private void WriteLine(ReadOnlySpan<byte> samples)
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
