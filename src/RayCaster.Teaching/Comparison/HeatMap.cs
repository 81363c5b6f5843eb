namespace RayCaster.Teaching.Comparison;

/// <summary>The colours of differences, and pictures of them.</summary>
public static class HeatMap
{
    /// <summary>The colour of a difference: black for none, clearly visible for 1 level, then by the logarithm.</summary>
    /// <param name="levels">0 … 255.</param>
    public static (byte R, byte G, byte B) ColorOf(int levels) =>
        levels == 0 ? default : ColorRamp.Inferno.At(1.5 + (ColorRamp.Inferno.Last - 1.5) * Math.Log2(levels) / Math.Log2(255));

    /// <summary>Each pixel in the colour of its difference.</summary>
    public static Picture Draw(PictureDifference difference)
    {
        var colors = Enumerable.Range(0, 256).Select(ColorOf).ToArray();
        var (width, height) = (difference.Mine.Width, difference.Mine.Height);
        return Picture.Create(width, height, (x, y) => colors[difference.LevelsAt(y * width + x)]);
    }

    /// <summary>Each model in one colour: the larger the share of its pixels that are wrong, the hotter. Black if the pictures were not compared
    /// model by model.</summary>
    public static Picture ByModel(PictureComparison comparison)
    {
        var (width, height) = (comparison.Reference.Width, comparison.Reference.Height);
        if (comparison.ByModels is not { } byModels) return new(width, height);
        var colors = byModels.Models.ToDictionary(model => model.Model, model => ColorOf((int)Math.Ceiling(255 * model.Share)));
        return Picture.Create(width, height, (x, y) => colors.GetValueOrDefault(byModels.ModelAt[y * width + x]));
    }
}
