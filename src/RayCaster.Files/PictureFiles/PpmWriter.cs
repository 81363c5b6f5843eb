namespace RayCaster.Files;

/// <summary>Writes PPM in bytes: the header, then the bytes of the pixels.</summary>
internal sealed class PpmWriter : PictureWriter
{
    public PpmWriter(Stream output, int width, int height) : base(output, width, height) =>
        output.Write(Encoding.ASCII.GetBytes($"P6\n{width} {height}\n255\n"));

    private protected override void Encode(ReadOnlySpan<byte> lines) => Output.Write(lines);
}
