namespace RayCaster.Files;

/// <summary>One picture that shows many pictures side by side, made small.</summary>
/// <param name="pictures">The files, PNGs of any size that are not interlaced.</param>
public sealed class ContactSheet(IReadOnlyList<string> pictures, int columns, int width, int height)
{
    /// <summary>Black pixels between two pictures, and around all.</summary>
    public const int Gap = 4;

    /// <summary>Pixels in a line of the sheet.</summary>
    public long Width => (long)columns * (width + Gap) + Gap;

    /// <summary>Lines of the sheet.</summary>
    public long Height => (long)((pictures.Count - 1) / columns + 1) * (height + Gap) + Gap;

    /// <summary>The default size of small pictures: at most 160 pixels wide, with the proportions of the given picture.</summary>
    /// <exception cref="ProblemException">It cannot be read.</exception>
    public static (int Width, int Height) SizeFor(string picture) => PngReader.OpenFile(picture, png =>
    {
        var width = Math.Min(png.Header.Width, 160);
        return (width, (int)Math.Clamp(((long)png.Header.Height * width + png.Header.Width / 2) / png.Header.Width, 1, 1000));
    });

    /// <summary>Writes the sheet, a row of small pictures at a time.</summary>
    /// <param name="writer">Receives the lines; it is not finished.</param>
    /// <exception cref="ProblemException">A picture cannot be read.</exception>
    public void Write(PictureWriter writer, CancellationToken cancellation = default)
    {
        var lineBytes = 3 * (int)Width;
        var row = new byte[lineBytes * (Gap + height)];
        for (var first = 0; first < pictures.Count; first += columns)
        {
            row.AsSpan().Clear();
            for (var i = first; i < Math.Min(first + columns, pictures.Count); i++)
            {
                cancellation.ThrowIfCancellationRequested();
                Shrink(pictures[i], row.AsSpan(Gap * lineBytes + 3 * (Gap + (i - first) * (width + Gap))), lineBytes);
            }
            writer.WriteRows(row);
        }
        writer.WriteRows(new byte[Gap * lineBytes]);
    }

    private void Shrink(string picture, Span<byte> corner, int lineBytes)
    {
        var small = PngReader.OpenFile(picture, png =>
        {
            png.RequireLines();
            var made = new SmallPicture(png.Header.Width, png.Header.Height, width, height);
            png.ReadLines(made.Take);
            return made.Picture;
        });
        for (var y = 0; y < height; y++) small.Rgb.AsSpan(3 * width * y, 3 * width).CopyTo(corner[(y * lineBytes)..]);
    }
}
