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

    /// <summary>How many pixels differ at all, and the first of them from the top, in words.</summary>
    public static string Describe(Picture expected, Picture actual)
    {
        for (var y = 0; y < expected.Height; y++)
            for (var x = 0; x < expected.Width; x++)
                if (expected[x, y] != actual[x, y])
                    return $"{Count(expected, actual, levels: 0)} of {expected.Width * expected.Height} pixels differ; "
                        + $"the first at column {x}, row {expected.Height - 1 - y} from the bottom: expected {expected[x, y]}, got {actual[x, y]}";
        return "no pixel differs";
    }

    /// <summary>The greatest difference of the three channels.</summary>
    private static int Levels((byte R, byte G, byte B) a, (byte R, byte G, byte B) b) =>
        Math.Max(Math.Abs(a.R - b.R), Math.Max(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));
}
