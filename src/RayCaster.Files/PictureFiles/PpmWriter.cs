using System.Text;

namespace RayCaster.Files;

/// <summary>PPM in bytes: the header, then the pixels as they are.</summary>
internal sealed class PpmWriter : PictureWriter
{
    public PpmWriter(Stream output, int width, int height) : base(output, width, height) =>
        output.Write(Encoding.ASCII.GetBytes($"P6\n{width} {height}\n255\n"));

    private protected override void Encode(ReadOnlySpan<byte> lines) => Output.Write(lines);
}
