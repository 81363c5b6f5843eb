namespace RayCaster.Tests.Mistakes;

/// <summary>How much two pictures differ.</summary>
internal static class PictureDifference
{
    /// <summary>The pixels in which a channel differs by more than so many levels, or that only the first picture has.</summary>
    public static int Count(Picture expected, Picture actual, int levels)
    {
        var count = 0;
        for (var y = 0; y < expected.Height; y++)
            for (var x = 0; x < expected.Width; x++)
                if (x >= actual.Width || y >= actual.Height || Levels(expected[x, y], actual[x, y]) > levels) count++;
        return count;
    }

    /// <summary>The greatest difference of the three channels.</summary>
    private static int Levels((byte R, byte G, byte B) a, (byte R, byte G, byte B) b) =>
        Math.Max(Math.Abs(a.R - b.R), Math.Max(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));
}
