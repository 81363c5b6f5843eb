namespace RayCaster.Teaching.Comparison;

/// <summary>Draws two pictures and the heat map of their difference beside each other.</summary>
public static class SideBySide
{
    /// <summary>Pixels of grey between two pictures.</summary>
    private const int Gap = 2;

    private const byte Grey = 128;

    /// <summary>Mine, the reference, the heat map, from left to right; without the heat map where the sizes differ.</summary>
    /// <exception cref="ProblemException">It would be larger than a picture can be.</exception>
    public static Picture Draw(PictureComparison comparison)
    {
        var (mine, reference) = (comparison.Mine, comparison.Reference);
        var width = mine.Width + (long)Gap + reference.Width + (comparison.Difference is null ? 0 : Gap + (long)mine.Width);
        var height = Math.Max(mine.Height, reference.Height);
        PictureFile.ThrowIfTooLarge(width, height);
        var picture = new Picture((int)width, height);
        Array.Fill(picture.Rgb, Grey);
        Put(mine, picture, 0);
        Put(reference, picture, mine.Width + Gap);
        if (comparison.Difference is { } difference) Put(HeatMap.Draw(difference), picture, 2 * (mine.Width + Gap));
        return picture;
    }

    private static void Put(Picture part, Picture whole, int left)
    {
        for (var y = 0; y < part.Height; y++)
            part.Rgb.AsSpan(y * part.Width * 3, part.Width * 3).CopyTo(whole.Rgb.AsSpan((y * whole.Width + left) * 3));
    }
}
