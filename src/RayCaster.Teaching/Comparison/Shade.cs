namespace RayCaster.Teaching.Comparison;

/// <summary>Whether bytes are a model's colour in some light.</summary>
internal static class Shade
{
    /// <summary>By less than this a channel of a shade differs from the light times the colour.</summary>
    private const int Near = 3;

    /// <summary>Whether bytes are a colour in a light that clamps no channel.</summary>
    public static bool IsOf((byte R, byte G, byte B) bytes, Color color)
    {
        var most = Most(color);
        if (most == 0) return bytes == default;
        var light = LightOf(bytes, color);
        return Math.Abs(bytes.R - 255 * light * color.R) < Near && Math.Abs(bytes.G - 255 * light * color.G) < Near
            && Math.Abs(bytes.B - 255 * light * color.B) < Near;
    }

    /// <summary>Whether bytes are a colour in a light so bright that channels are clamped; the brightest of the others gives the light.</summary>
    public static bool IsTooBright((byte R, byte G, byte B) bytes, Color color)
    {
        ReadOnlySpan<(byte Byte, double Channel)> channels = [(bytes.R, color.R), (bytes.G, color.G), (bytes.B, color.B)];
        var light = double.MaxValue; // all clamped: any light from some brightness on
        var most = 0.0;
        foreach (var (shown, channel) in channels)
            if (shown < byte.MaxValue && channel > most) (light, most) = (shown / channel, channel);
        foreach (var (shown, channel) in channels)
            if (Math.Abs(shown - Math.Min(byte.MaxValue, light * channel)) >= Near) return false;
        return true;
    }

    /// <summary>The brightest light in which a shade of a colour is so bright; 0 for black, whose shades tell nothing of the light.</summary>
    public static double MostLightOf((byte R, byte G, byte B) shade, Color color) =>
        Most(color) == 0 ? 0 : LightOf(shade, color) + Near / (255 * Most(color));

    private static double LightOf((byte R, byte G, byte B) shade, Color color) =>
        Math.Max(shade.R, Math.Max(shade.G, shade.B)) / (255 * Most(color));

    private static double Most(Color color) => Math.Max(color.R, Math.Max(color.G, color.B));
}
