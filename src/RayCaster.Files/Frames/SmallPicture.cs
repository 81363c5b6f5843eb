namespace RayCaster.Files;

/// <summary>Makes a picture small: each pixel is the mean of the pixels that it covers. A picture that is smaller already is enlarged.</summary>
internal static class SmallPicture
{
    /// <summary>Reads the next line, three bytes for each pixel.</summary>
    public delegate void LineReader(Span<byte> rgb);

    public static Picture Of(int fromWidth, int fromHeight, LineReader readLine, int width, int height)
    {
        var small = new Picture(width, height);
        var line = new byte[3 * fromWidth];
        var (sums, read) = (new long[3 * width], 0);
        for (var y = 0; y < height; y++)
        {
            var (top, bottom) = Covered(y, height, fromHeight);
            Array.Clear(sums);
            for (var i = top; i < bottom; i++)
            {
                for (; read <= i; read++) readLine(line);
                for (var x = 0; x < width; x++)
                {
                    var (left, right) = Covered(x, width, fromWidth);
                    for (var from = 3 * left; from < 3 * right; from++) sums[3 * x + from % 3] += line[from];
                }
            }
            for (var x = 0; x < width; x++)
            {
                var (left, right) = Covered(x, width, fromWidth);
                var count = (long)(right - left) * (bottom - top);
                for (var c = 3 * x; c < 3 * x + 3; c++) small.Rgb[3 * width * y + c] = (byte)((sums[c] + count / 2) / count);
            }
        }
        return small;
    }

    /// <summary>Which pixels of many a small pixel covers: at least one.</summary>
    private static (int From, int To) Covered(int place, int places, int many)
    {
        var from = (int)((long)place * many / places);
        return (from, Math.Max(from + 1, (int)((place + 1L) * many / places)));
    }
}
