namespace RayCaster;

/// <summary>A colour as intensities, not bytes: 1 is full intensity; more is allowed, and clamped only in the picture.</summary>
/// <param name="R">Red, at least 0.</param>
/// <param name="G">Green, at least 0.</param>
/// <param name="B">Blue, at least 0.</param>
public readonly record struct Color(double R, double G, double B)
{
    /// <summary>The default background of a scene.</summary>
    public static Color Black => default;

    /// <summary>The default colour of a model.</summary>
    public static Color White => new(1, 1, 1);

    /// <summary>The same colour, darker or brighter.</summary>
    public static Color operator *(double attenuation, Color color) =>
        new(attenuation * color.R, attenuation * color.G, attenuation * color.B);

    /// <summary>The three bytes of a pixel: the whole part of each channel's <see cref="Level"/>; no gamma. NaN gives 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public (byte R, byte G, byte B) ToBytes() => (ToByte(R), ToByte(G), ToByte(B));

    /// <summary>A channel clamped to 0 … 1, times 255, plus ½: its whole part is the byte, rounded to nearest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static N Level<N>(N channel) where N : struct, IReal<N> => N.Min(N.Max(channel, 0), 1) * 255 + 0.5;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static byte ToByte(double channel) => (byte)Level<Scalar>(channel);
}
