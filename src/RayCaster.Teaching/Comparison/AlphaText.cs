namespace RayCaster.Teaching.Comparison;

/// <summary>What is said of a picture file's alpha, which no comparison of colours shows.</summary>
public static class AlphaText
{
    private const string Multiplied = "The colours are the right ones multiplied by the file's alpha (\"premultiplied\"): " +
        "a PNG stores them as they are. Write them so, with an alpha of 255, or none.";

    /// <summary>A sentence for a file with alpha; null if each pixel is opaque.</summary>
    /// <param name="alpha">The file's alpha; null if each pixel is opaque.</param>
    /// <param name="right">The right picture, for colours that were multiplied by alpha.</param>
    public static string? Describe(AlphaChannel? alpha, Picture picture, Picture right)
    {
        if (alpha is null) return null;
        if (IsMultiplied(alpha, picture, right)) return Multiplied;
        var values = alpha.Values;
        var (least, most) = (values.Min(), values.Max());
        var empty = values.Count(value => value == 0);
        return most == 0 ? "The file's alpha is 0 in every pixel: a viewer shows nothing. Write 255, or no alpha."
            : empty > 0 ? $"The file's alpha is 0 in {Digits.Part(empty, values.Count)}: a viewer shows nothing there. Write 255, or no alpha."
            : least == most ? $"The file's alpha is {most} in every pixel, and 255 is all of it: " +
                $"a viewer shows {(most < 10 ? "nearly nothing" : "what lies behind, too")}. Write 255, or no alpha."
            : $"The file's alpha is {least} to {most}, and 255 is all of it: a viewer shows what lies behind, too. Write 255, or no alpha.";
    }

    /// <summary>Whether a picture is wrong, but right if its colours were multiplied by alpha.</summary>
    public static bool IsMultiplied(AlphaChannel? alpha, Picture picture, Picture right)
    {
        if (alpha is null || (picture.Width, picture.Height) != (right.Width, right.Height) || picture.IsNearlyOneColor) return false;
        var values = alpha.Values;
        var multiplied = Picture.Create(right.Width, right.Height, (x, y) => Times(right[x, y], values[y * right.Width + x]));
        var difference = new PictureDifference(picture, multiplied);
        return new PictureDifference(picture, right).Wrong > 0 && new PictureJudge(multiplied).Judge(difference) != Likeness.Wrong;
    }

    private static (byte, byte, byte) Times((byte R, byte G, byte B) color, byte alpha) =>
        ((byte)((color.R * alpha + 127) / 255), (byte)((color.G * alpha + 127) / 255), (byte)((color.B * alpha + 127) / 255));
}
