namespace RayCaster.Files;

/// <summary>Makes a picture small: each pixel is the mean of the pixels that it covers. A picture that is smaller already is enlarged.</summary>
public sealed class SmallPicture(int fromWidth, int fromHeight, int width, int height)
{
    private readonly long[] sums = new long[3 * width]; // of the small line that the next lines belong to
    private int linesTaken, linesDone;

    /// <summary>The small picture. Its lines are black until all that they cover were taken.</summary>
    public Picture Picture { get; } = new(width, height);

    /// <summary>Adds the next lines.</summary>
    /// <param name="rgb">Whole lines, three bytes for each pixel.</param>
    public void Take(ReadOnlySpan<byte> rgb)
    {
        for (; rgb.Length > 0; rgb = rgb[(3 * fromWidth)..], linesTaken++)
        {
            for (; linesDone < height; linesDone++)
            {
                var (top, bottom) = Covered(linesDone, height, fromHeight);
                if (linesTaken < top) break;
                for (var x = 0; x < width; x++)
                {
                    var (left, right) = Covered(x, width, fromWidth);
                    for (var from = 3 * left; from < 3 * right; from++) sums[3 * x + from % 3] += rgb[from];
                }
                if (linesTaken < bottom - 1) break;
                Finish(bottom - top);
            }
        }
    }

    private void Finish(int lines)
    {
        for (var i = 0; i < sums.Length; i++)
        {
            var (left, right) = Covered(i / 3, width, fromWidth);
            var count = (long)(right - left) * lines;
            Picture.Rgb[sums.Length * linesDone + i] = (byte)((sums[i] + count / 2) / count);
        }
        Array.Clear(sums);
    }

    /// <summary>Which of so many pixels a small pixel covers: at least one.</summary>
    private static (int From, int To) Covered(int index, int count, int pixels)
    {
        var from = (int)((long)index * pixels / count);
        return (from, Math.Max(from + 1, (int)((index + 1L) * pixels / count)));
    }
}
