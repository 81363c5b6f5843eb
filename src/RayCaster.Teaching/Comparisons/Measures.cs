namespace RayCaster.Teaching;

/// <summary>
/// The difference of two pictures as single numbers, over all bytes of all channels. No such number shows whether a picture is right: a
/// missing ball may change it less than truncated bytes do. All but SSIM agree with ImageMagick 6's <c>compare</c>, which has no SSIM.
/// </summary>
public sealed class Measures
{
    /// <summary>Computes all measures.</summary>
    public Measures(PictureDifference difference)
    {
        var (mine, reference) = (difference.Mine, difference.Reference);
        long sum = 0, squares = 0;
        for (var i = 0; i < mine.Rgb.Length; i++)
        {
            var d = mine.Rgb[i] - reference.Rgb[i];
            sum += Math.Abs(d);
            squares += d * d;
        }
        Maximum = difference.Largest;
        MeanAbsoluteError = (double)sum / mine.Rgb.Length;
        RootMeanSquareError = Math.Sqrt((double)squares / mine.Rgb.Length);
        StructuralSimilarity = RayCaster.Teaching.StructuralSimilarity.Of(mine, reference);
    }

    /// <summary>The largest difference, in levels of 255.</summary>
    public int Maximum { get; }

    /// <summary>The mean of the differences' absolute values, in levels (MAE).</summary>
    public double MeanAbsoluteError { get; }

    /// <summary>The root of the mean of the differences' squares, in levels (RMSE).</summary>
    public double RootMeanSquareError { get; }

    /// <summary>20 log10(255 / RMSE) decibels (PSNR); +∞ for identical pictures.</summary>
    public double PeakSignalToNoiseRatio => 20 * Math.Log10(255 / RootMeanSquareError);

    /// <summary>SSIM: 1 for identical pictures, about 0 for unrelated ones (Wang, Bovik, Sheikh, Simoncelli 2004).</summary>
    public double StructuralSimilarity { get; }
}
