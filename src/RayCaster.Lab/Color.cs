namespace Lab;

/// <summary>Light: 1 is full intensity; more is allowed, and clamped only in the picture.</summary>
public class Color(double r, double g, double b)
{
    public double R = r, G = g, B = b;

    public static Color operator *(double attenuation, Color color) =>
        new(attenuation * color.R, attenuation * color.G, attenuation * color.B);

    /// <summary>The three bytes of a pixel.</summary>
    public (byte R, byte G, byte B) ToBytes() => (ToByte(R), ToByte(G), ToByte(B));

    /// <summary>Clamped before it is cast, since a cast of 1.2 * 255 = 306 to a byte gives 306 − 256 = 50; rounded to nearest by + 0.5, since a cast
    /// only drops the fraction.</summary>
    private static byte ToByte(double channel) => (byte)(Math.Clamp(channel, 0, 1) * 255 + 0.5);
}
