namespace RayCaster.Teaching.Hypotheses;

/// <summary>Pictures that show so little that very many mistakes draw them.</summary>
internal static class PlainPicture
{
    /// <summary>At most this share of the pixels is neither background nor black, and at least this share should be.</summary>
    private const double Hardly = 0.005, Enough = 0.05;

    /// <summary>What such a picture shows, and where to look; null if the picture shows more, or the right one shows as little.</summary>
    public static string? Describe(Scene scene, Picture picture, Picture right)
    {
        if (picture.IsNearlyOneColor && (IsOneShade(scene, picture) || right.IsNearlyOneColor))
            return $"Every pixel has the same colour, {picture.OneColorInWords}: do the rays of two pixels differ?";
        var background = scene.Background.ToBytes();
        if (!picture.IsNearlyOneColor && Count(right, IsColored) < Enough * right.Count) return null;
        var most = Hardly * picture.Count;
        if (Count(picture, IsColored) > most)
        {
            return Count(picture, shown => IsColored(shown) && !IsWhite(shown)) <= most && Count(right, shown => !IsGrey(shown)) > most
                ? "All that is drawn is white: no model's colour shows. Look at the attenuation, and at the way from a colour to its bytes." : null;
        }
        if (IsBlack(background))
            return "The picture is black, and so is the background: either no hit counts, or all light is lost. " +
                "Which hits count, and what is the attenuation?";
        return Count(picture, IsBlack) <= most
            ? "There is nothing but background: no model is hit, or no hit counts."
            : "All that is drawn is black: the light is lost. Is the attenuation, or a colour on its way to bytes, cut to an integer or negative?";

        bool IsColored((byte, byte, byte) shown) => PlainPicture.IsColored(scene, shown);
    }

    /// <summary>Whether every pixel has the same colour but for a level or two, and neither black nor the background's.</summary>
    public static bool IsOneShade(Scene scene, Picture picture) => picture.IsNearlyOneColor && IsColored(scene, picture.At(picture.Count / 2));

    private static bool IsColored(Scene scene, (byte, byte, byte) shown) =>
        !IsBlack(shown) && !PictureJudge.IsNear(shown, scene.Background.ToBytes());

    private static bool IsBlack((byte R, byte G, byte B) shown) => PictureJudge.IsNear(shown, default);

    private static bool IsWhite((byte R, byte G, byte B) shown) => Math.Min(shown.R, Math.Min(shown.G, shown.B)) == byte.MaxValue;

    private static bool IsGrey((byte R, byte G, byte B) shown) =>
        Math.Max(shown.R, Math.Max(shown.G, shown.B)) - Math.Min(shown.R, Math.Min(shown.G, shown.B)) <= PictureJudge.Tolerance;

    private static int Count(Picture picture, Func<(byte, byte, byte), bool> isSo) =>
        Enumerable.Range(0, picture.Count).Count(place => isSo(picture.At(place)));
}
