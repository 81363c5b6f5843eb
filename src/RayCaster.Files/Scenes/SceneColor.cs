namespace RayCaster.Files;

/// <summary>Colours as a scene file writes them.</summary>
internal static class SceneColor
{
    public const string Form = "an array of three numbers [red, green, blue] or a text like \"#ff8800\"";

    /// <summary>Reads <c>#rrggbb</c>, each pair of digits / 255; null for any other text.</summary>
    public static Color? Parse(string text) =>
        text.Length == 7 && text[0] == '#' && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, null, out var rgb)
            ? new((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0)
            : null;

    /// <summary>Whether three numbers were probably meant as bytes: whole, and one of them above 9. False where one is NaN.</summary>
    public static bool LooksLikeBytes(Vector3 c) =>
        Math.Max(c.X, Math.Max(c.Y, c.Z)) is > 9 and <= 255 && double.IsInteger(c.X) && double.IsInteger(c.Y) && double.IsInteger(c.Z);
}
