namespace RayCaster.Teaching.Visibility;

/// <summary>A float for each pixel. Line 0 is at the top.</summary>
/// <exception cref="OverflowException">The map would have 2³¹ numbers or more.</exception>
public sealed record NumberMap(int Width, int Height)
{
    /// <summary>Width · Height numbers; from left to right, then from top to bottom.</summary>
    public float[] Values { get; } = new float[checked(Width * Height)];

    /// <summary>The number of a pixel.</summary>
    /// <param name="x">The column, from the left.</param>
    /// <param name="y">The line, from the top.</param>
    public ref float this[int x, int y] => ref Values[y * Width + x];

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
