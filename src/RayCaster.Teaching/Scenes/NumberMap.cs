namespace RayCaster.Teaching;

/// <summary>One or three floats for each pixel. Line 0 is at the top.</summary>
/// <param name="Channels">1, or 3 for vectors.</param>
/// <exception cref="OverflowException">The map would have 2³¹ numbers or more.</exception>
public sealed record NumberMap(int Width, int Height, int Channels)
{
    /// <summary>Width · Height · Channels numbers; from left to right, then from top to bottom.</summary>
    public float[] Values { get; } = new float[checked(Width * Height * Channels)];

    /// <summary>The numbers of a pixel.</summary>
    /// <param name="x">The column, from the left.</param>
    /// <param name="y">The line, from the top.</param>
    public Span<float> this[int x, int y] => Values.AsSpan(((y * Width) + x) * Channels, Channels);

    /// <summary>The least and the greatest finite number; null if there is none.</summary>
    public (float Least, float Greatest)? Range
    {
        get
        {
            var (least, greatest) = (float.PositiveInfinity, float.NegativeInfinity);
            foreach (var value in Values)
                if (float.IsFinite(value))
                    (least, greatest) = (Math.Min(least, value), Math.Max(greatest, value));
            return least <= greatest ? (least, greatest) : null;
        }
    }
}
