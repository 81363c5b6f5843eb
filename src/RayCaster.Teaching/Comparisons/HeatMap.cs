namespace RayCaster.Teaching;

/// <summary>
/// The colours of differences: from black over purple, red and orange to a pale yellow, each lighter than the one before, so that the order
/// is seen on any screen, in print and by the colour-blind (nine colours of the scale "inferno" of matplotlib, S. van der Walt and N. Smith 2015).
/// </summary>
public static class HeatMap
{
    private static readonly (byte R, byte G, byte B)[] scale =
    [
        (0, 0, 4), (31, 12, 72), (85, 15, 109), (136, 34, 106), (186, 54, 85), (227, 89, 51), (249, 140, 10), (249, 201, 50), (252, 255, 164),
    ];

    /// <summary>The colour of a difference: black for none, at once visible for 1 level, then by the logarithm.</summary>
    /// <param name="levels">0 … 255.</param>
    public static (byte R, byte G, byte B) Of(int levels)
    {
        if (levels == 0) return default;
        var place = 1.5 + (scale.Length - 2.5) * Math.Log2(levels) / Math.Log2(255);
        var below = Math.Min((int)place, scale.Length - 2);
        var (a, b, share) = (scale[below], scale[below + 1], place - below);
        return (Between(a.R, b.R, share), Between(a.G, b.G, share), Between(a.B, b.B, share));
    }

    private static byte Between(byte a, byte b, double share) => (byte)(a + (b - a) * share + 0.5);
}
