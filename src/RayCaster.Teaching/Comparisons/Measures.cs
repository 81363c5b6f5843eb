namespace RayCaster.Teaching;

/// <summary>
/// The difference of two pictures as single numbers, over all bytes of all channels. No such number shows whether a picture is right: a
/// missing ball may change it less than truncated bytes do. All but SSIM agree with ImageMagick 6's <c>compare</c>, which has no SSIM.
/// </summary>
public sealed class Measures(PictureDifference difference)
{
    /// <summary>The largest difference, in levels of 255.</summary>
    public int Maximum => difference.Largest;

    /// <summary>The mean of the differences' absolute values, in levels (MAE).</summary>
    public double MeanAbsoluteError { get; } = Mean(difference, Math.Abs);

    /// <summary>The root of the mean of the differences' squares, in levels (RMSE).</summary>
    public double RootMeanSquareError { get; } = Math.Sqrt(Mean(difference, d => d * d));

    /// <summary>20 log10(255 / RMSE) decibels (PSNR); +∞ for identical pictures.</summary>
    public double PeakSignalToNoiseRatio => 20 * Math.Log10(255 / RootMeanSquareError);

    /// <summary>SSIM: 1 for identical pictures, about 0 for unrelated ones (Wang, Bovik, Sheikh, Simoncelli 2004).</summary>
    public double StructuralSimilarity { get; } = Teaching.StructuralSimilarity.Of(difference.Mine, difference.Reference);

    private static double Mean(PictureDifference difference, Func<int, int> measure)
    {
        var (mine, reference, sum) = (difference.Mine.Rgb, difference.Reference.Rgb, 0L);
        for (var i = 0; i < mine.Length; i++) sum += measure(mine[i] - reference[i]);
        return (double)sum / mine.Length;
    }
}
