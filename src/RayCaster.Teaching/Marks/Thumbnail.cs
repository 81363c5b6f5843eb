namespace RayCaster.Teaching;

/// <summary>Makes small copies of pictures: each pixel is the mean of the pixels that it replaces.</summary>
internal static class Thumbnail
{
    /// <summary>The longer side of a copy for people, and of a copy for comparing.</summary>
    public const int Seen = 120, Tiny = 16;

    /// <summary>A copy whose longer side has so many pixels; a smaller picture itself.</summary>
    public static Picture Of(Picture picture, int side)
    {
        var longer = Math.Max(picture.Width, picture.Height);
        if (longer <= side) return picture;
        var small = new Picture(Math.Max(1, picture.Width * side / longer), Math.Max(1, picture.Height * side / longer));
        for (var y = 0; y < small.Height; y++)
            for (var x = 0; x < small.Width; x++)
                small[x, y] = Mean(picture, Range(x, small.Width, picture.Width), Range(y, small.Height, picture.Height));
        return small;
    }

    /// <summary>The bytes of a PNG file.</summary>
    public static byte[] ToPng(this Picture picture)
    {
        using var bytes = new MemoryStream();
        PictureFile.Write(bytes, picture, PictureFormat.Png);
        return bytes.ToArray();
    }

    private static (int From, int To) Range(int i, int small, int large) => ((int)((long)i * large / small), (int)((i + 1L) * large / small));

    private static (byte, byte, byte) Mean(Picture picture, (int From, int To) columns, (int From, int To) lines)
    {
        var (r, g, b, count) = (0, 0, 0, 0);
        for (var y = lines.From; y < lines.To; y++)
            for (var x = columns.From; x < columns.To; x++)
            {
                var pixel = picture[x, y];
                (r, g, b, count) = (r + pixel.R, g + pixel.G, b + pixel.B, count + 1);
            }
        return ((byte)(r / count), (byte)(g / count), (byte)(b / count));
    }
}
