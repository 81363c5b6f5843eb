namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>Counts what a mistake changes; some change the picture's size too.</summary>
internal static class ChangedPixels
{
    /// <summary>The pixels in which a channel differs by more than so many levels, or that only the first picture has.</summary>
    public static int Count(Picture expected, Picture actual, int levels)
    {
        if ((expected.Width, expected.Height) == (actual.Width, actual.Height)) return new PictureDifference(actual, expected).CountBeyond(levels);
        var (width, height) = (Math.Min(expected.Width, actual.Width), Math.Min(expected.Height, actual.Height));
        var common = new PictureDifference(Corner(actual, width, height), Corner(expected, width, height));
        return common.CountBeyond(levels) + expected.Width * expected.Height - common.Pixels;
    }

    /// <summary>The upper left corner of a picture.</summary>
    private static Picture Corner(Picture picture, int width, int height)
    {
        var corner = new Picture(width, height);
        for (var y = 0; y < height; y++)
            for (var x = 0; x < width; x++) corner[x, y] = picture[x, y];
        return corner;
    }
}
