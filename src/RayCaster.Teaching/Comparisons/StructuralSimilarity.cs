namespace RayCaster.Teaching;

/// <summary>
/// The structural similarity index of Wang, Bovik, Sheikh and Simoncelli ("Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Transactions on Image Processing 13(4), 2004): windows of 11 × 11 pixels under a Gaussian, σ = 1.5, K1 = 0.01, K2 = 0.03,
/// one window around each pixel, the mean of the three channels. Beyond the border the outermost pixels are repeated, as in ImageMagick.
/// </summary>
internal static class StructuralSimilarity
{
    private const int Radius = 5, Taps = 2 * Radius + 1;
    private const double Sigma = 1.5;
    private const double C1 = 0.01 * 255 * (0.01 * 255), C2 = 0.03 * 255 * (0.03 * 255);

    private static readonly double[] weights = Weights();

    /// <summary>1 for equal pictures of the same size, less for others.</summary>
    public static double Of(Picture mine, Picture reference)
    {
        var sums = new double[mine.Height];
        Parallel.For(0, mine.Height, () => new Moments[mine.Width * 3], (y, _, columns) =>
        {
            sums[y] = OfLine(mine, reference, y, columns);
            return columns;
        }, _ => { });
        return sums.Sum() / ((double)mine.Width * mine.Height * 3); // in order, so that the last bits do not depend on the threads
    }

    /// <summary>exp(−k² / 2σ²), scaled to the sum 1; the window is the product of one such row and one such column.</summary>
    private static double[] Weights()
    {
        var weights = Enumerable.Range(-Radius, Taps).Select(k => Math.Exp(-k * k / (2 * Sigma * Sigma))).ToArray();
        var sum = weights.Sum();
        return Array.ConvertAll(weights, weight => weight / sum);
    }

    /// <summary>The sum of the index over a line's bytes: the means of x, y, x², y² and xy under each window, first down, then along.</summary>
    private static double OfLine(Picture mine, Picture reference, int y, Moments[] columns)
    {
        var length = columns.Length;
        Array.Clear(columns);
        for (var k = 0; k < Taps; k++)
        {
            var line = Math.Clamp(y + k - Radius, 0, mine.Height - 1) * length;
            for (var i = 0; i < length; i++) columns[i].Add(weights[k], Moments.Of(mine.Rgb[line + i], reference.Rgb[line + i]));
        }
        var sum = 0.0;
        for (var i = 0; i < length; i++)
        {
            var mean = default(Moments);
            for (var k = 0; k < Taps; k++)
                mean.Add(weights[k], columns[Math.Clamp(i / 3 + k - Radius, 0, mine.Width - 1) * 3 + i % 3]);
            var (vx, vy, vxy) = (mean.XX - mean.X * mean.X, mean.YY - mean.Y * mean.Y, mean.XY - mean.X * mean.Y);
            sum += (2 * mean.X * mean.Y + C1) * (2 * vxy + C2) / ((mean.X * mean.X + mean.Y * mean.Y + C1) * (vx + vy + C2));
        }
        return sum;
    }

    private record struct Moments(double X, double Y, double XX, double YY, double XY)
    {
        public static Moments Of(double x, double y) => new(x, y, x * x, y * y, x * y);

        public void Add(double weight, Moments m) =>
            (X, Y, XX, YY, XY) = (X + weight * m.X, Y + weight * m.Y, XX + weight * m.XX, YY + weight * m.YY, XY + weight * m.XY);
    }
}
