namespace RayCaster.Files;

/// <summary>
/// Joins pictures into one animated PNG (APNG, part of the third edition of the PNG specification). Browsers play it in a loop; programs that
/// do not know APNG show the first picture. The pictures' compressed data are copied, a piece at a time.
/// </summary>
public static class AnimationFile
{
    private const int Piece = 1 << 20;

    /// <summary>Writes an animation.</summary>
    /// <param name="frames">The pictures, as this program draws them: PNG of red, green and blue, 8 bits each, not interlaced; all of one
    /// size.</param>
    /// <param name="framesPerSecond">1 to 1000.</param>
    /// <exception cref="ProblemException">A picture cannot be read, is damaged, or of another size or kind.</exception>
    public static void Write(Stream output, IReadOnlyList<string> frames, int framesPerSecond, CancellationToken cancellation = default)
    {
        PngHeader? first = null;
        var sequence = 0u; // counts the chunks fcTL and fdAT
        var piece = new byte[4 + Piece];
        foreach (var path in frames)
        {
            cancellation.ThrowIfCancellationRequested();
            PngReader.OpenFile(path, png =>
            {
                var header = png.Header;
                Check(header, first ?? header, frames[0]);
                if (png.IsAnimation) throw new ProblemException("it is an animation, not a single picture");
                png.ReadLines(_ => { }); // otherwise the animation could contain damaged data
                if (first is null)
                {
                    output.Write(PngChunk.Signature);
                    PngChunk.Write(output, "IHDR"u8, header.ToBytes());
                    PngChunk.Write(output, "acTL"u8, Numbers((uint)frames.Count, 0)); // 0: plays without end
                }
                PngChunk.Write(output, "fcTL"u8, Control(sequence++, header, framesPerSecond));
                using var data = png.OpenCompressed();
                for (int length; (length = data.ReadAtLeast(piece.AsSpan(4), Piece, throwOnEndOfStream: false)) > 0;)
                {
                    if (first is null)
                    {
                        PngChunk.Write(output, "IDAT"u8, piece.AsSpan(4, length));
                        continue;
                    }
                    BinaryPrimitives.WriteUInt32BigEndian(piece, sequence++);
                    PngChunk.Write(output, "fdAT"u8, piece.AsSpan(0, 4 + length));
                }
                first ??= header;
                return true;
            });
        }
        PngChunk.Write(output, "IEND"u8, []);
    }

    private static void Check(PngHeader header, PngHeader first, string firstPath)
    {
        if (header is not { BitDepth: 8, ColorType: PngHeader.Rgb, Interlaced: false })
            throw new ProblemException("a frame must be a PNG of red, green and blue, 8 bits each, not interlaced, as this program draws it");
        if (header != first)
            throw new ProblemException(
                $"it has {header.Width} x {header.Height} pixels, but {firstPath} has {first.Width} x {first.Height}: frames are of one size");
    }

    /// <summary>The chunk before a frame: it covers the whole picture, replaces the frame before, and is shown for 1 / framesPerSecond.</summary>
    private static byte[] Control(uint sequence, PngHeader header, int framesPerSecond) =>
        [.. Numbers(sequence, (uint)header.Width, (uint)header.Height, 0, 0), 0, 1, (byte)(framesPerSecond >> 8), (byte)framesPerSecond, 0, 0];

    private static byte[] Numbers(params ReadOnlySpan<uint> numbers)
    {
        var bytes = new byte[4 * numbers.Length];
        for (var i = 0; i < numbers.Length; i++) BinaryPrimitives.WriteUInt32BigEndian(bytes.AsSpan(4 * i), numbers[i]);
        return bytes;
    }
}
