namespace RayCaster.Teaching;

/// <summary>
/// Separates pixels on outlines, which may show either side, from wrong pixels, by the pictures alone. A pixel may show the colour of a
/// neighbour, but only in thin lines, and only on a small part of all outlines: a shift by half a pixel changes about half of them.
/// </summary>
internal static class PictureOutlines
{
    /// <summary>How many levels a pixel may differ from its neighbour on the same model, because of the attenuation.</summary>
    private const int Shading = 2;

    /// <summary>One in so many pixels on outlines may show the other side.</summary>
    private const int Rarity = 20;

    /// <summary>Whether all pixels that differ by more than rounding are on outlines.</summary>
    public static bool HoldAllWrong(PictureDifference difference)
    {
        var (width, height) = (difference.Mine.Width, difference.Mine.Height);
        if (difference.Wrong > width * height / Rarity) return false;
        for (var y = 0; y < height; y++)
            for (var x = 0; x < width; x++)
                if (IsWrong(x, y) && (IsThick(x, y) || !difference.Reference.ShowsAround(x, y, difference.Mine[x, y])))
                    return false;
        return (difference.Wrong - 1) * Rarity < OnOutlines(difference.Reference);

        bool IsWrong(int x, int y) => x < width && y < height && difference.LevelsAt(y * width + x) > 1;

        bool IsThick(int x, int y) => IsWrong(x + 1, y) && IsWrong(x, y + 1) && IsWrong(x + 1, y + 1); // the upper left one of four
    }

    /// <summary>How many pixels differ from the pixel to the right or below.</summary>
    private static int OnOutlines(Picture picture) =>
        Enumerable.Range(0, picture.Count).Count(place => picture.IsEdge(place % picture.Width, place / picture.Width, Shading));
}
