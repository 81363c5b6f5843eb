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
                if (difference.LevelsAt(x, y) > 1 && (IsThick(difference, x, y) || !difference.Reference.ShowsAround(x, y, difference.Mine[x, y])))
                    return false;
        return (difference.Wrong - 1) * Rarity < OnOutlines(difference.Reference);
    }

    /// <summary>How many pixels differ from the pixel to the right or below.</summary>
    private static int OnOutlines(Picture picture) =>
        Enumerable.Range(0, picture.Count).Count(place => picture.IsEdge(place % picture.Width, place / picture.Width, Shading));

    /// <summary>Whether the pixel is the upper left one of four that all differ by more than rounding.</summary>
    private static bool IsThick(PictureDifference difference, int x, int y) =>
        x + 1 < difference.Mine.Width && y + 1 < difference.Mine.Height
        && difference.LevelsAt(x + 1, y) > 1 && difference.LevelsAt(x, y + 1) > 1 && difference.LevelsAt(x + 1, y + 1) > 1;
}
