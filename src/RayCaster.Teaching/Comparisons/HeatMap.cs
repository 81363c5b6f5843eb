namespace RayCaster.Teaching;

/// <summary>
/// The colours of differences: black, purple, red, orange, pale yellow. Each is lighter than the one before, so the order is visible in print
/// and to colour-blind people (nine colours of the scale "inferno" of matplotlib, S. van der Walt and N. Smith 2015).
/// </summary>
public static class HeatMap
{
    private static readonly (byte R, byte G, byte B)[] scale =
    [
        (0, 0, 4), (31, 12, 72), (85, 15, 109), (136, 34, 106), (186, 54, 85), (227, 89, 51), (249, 140, 10), (249, 201, 50), (252, 255, 164),
    ];

    /// <summary>The colour of a difference: black for none, clearly visible for 1 level, then by the logarithm.</summary>
    /// <param name="levels">0 … 255.</param>
    public static (byte R, byte G, byte B) Of(int levels)
    {
        if (levels == 0) return default;
        var place = 1.5 + (scale.Length - 2.5) * Math.Log2(levels) / Math.Log2(255);
        var below = Math.Min((int)place, scale.Length - 2);
        var (a, b, share) = (scale[below], scale[below + 1], place - below);
        return (Between(a.R, b.R, share), Between(a.G, b.G, share), Between(a.B, b.B, share));
    }

    /// <summary>Each model in one colour: the larger the share of its pixels that are wrong, the hotter. Black if the pictures were not compared
    /// model by model.</summary>
    public static Picture ByModel(PictureComparison comparison)
    {
        var (width, height) = (comparison.Reference.Width, comparison.Reference.Height);
        if (comparison.ByModels is not { } byModels) return new(width, height);
        var colors = byModels.Models.ToDictionary(model => model.Model, model => Of((int)Math.Ceiling(255 * model.Share)));
        return Picture.Of(width, height, (x, y) => colors.GetValueOrDefault(byModels.ModelAt(y * width + x)));
    }

    private static byte Between(byte a, byte b, double share) => (byte)(a + (b - a) * share + 0.5);
}
