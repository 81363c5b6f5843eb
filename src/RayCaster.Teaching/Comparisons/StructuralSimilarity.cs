using System.Numerics;
using System.Runtime.InteropServices;

namespace RayCaster.Teaching;

/// <summary>
/// The structural similarity index of Wang, Bovik, Sheikh and Simoncelli ("Image Quality Assessment: From Error Visibility to Structural
/// Similarity", IEEE Transactions on Image Processing 13(4), 2004): windows of 11 × 11 pixels under a Gaussian, σ = 1.5, K1 = 0.01, K2 = 0.03,
/// one window around each pixel, the mean of the three channels. Beyond the border the outermost pixels are repeated, as in ImageMagick.
/// </summary>
internal static class StructuralSimilarity
{
    private const int Radius = 5, Taps = 2 * Radius + 1, Moments = 5;
    private const double Sigma = 1.5;
    private const double C1 = 0.01 * 255 * (0.01 * 255), C2 = 0.03 * 255 * (0.03 * 255);

    private static readonly double[] weights = Weights();

    /// <summary>1 for equal pictures of the same size, less for others.</summary>
    public static double Of(Picture mine, Picture reference)
    {
        var sums = new double[mine.Height];
        var band = Math.Max(Taps, mine.Height / (4 * Environment.ProcessorCount));
        Parallel.For(0, (mine.Height + band - 1) / band, i =>
        {
            var lines = new Lines(mine, reference);
            for (var y = i * band; y < Math.Min(mine.Height, (i + 1) * band); y++) sums[y] = lines.SimilarityOf(y);
        });
        var sum = 0.0;
        foreach (var line in sums) sum += line; // in order, so that the last bits do not depend on the threads
        return sum / ((double)mine.Width * mine.Height * 3);
    }

    /// <summary>exp(−k² / 2σ²), scaled to the sum 1; the window is the product of one such row and one such column.</summary>
    private static double[] Weights()
    {
        var weights = new double[Taps];
        var sum = 0.0;
        for (var k = 0; k < Taps; k++) sum += weights[k] = Math.Exp(-(k - Radius) * (k - Radius) / (2 * Sigma * Sigma));
        for (var k = 0; k < Taps; k++) weights[k] /= sum;
        return weights;
    }

    /// <summary>The moments x, y, x², y², xy of the lines around one, each line computed once.</summary>
    private sealed class Lines
    {
        private readonly Picture mine, reference;
        private readonly int length;
        private readonly double[][] ring = new double[Taps * Moments][];
        private readonly int[] held = new int[Taps];
        private readonly double[] column, window;
        private readonly double[][] mean = new double[Moments][];

        public Lines(Picture mine, Picture reference)
        {
            (this.mine, this.reference, length) = (mine, reference, mine.Width * 3);
            for (var i = 0; i < ring.Length; i++) ring[i] = new double[length];
            for (var i = 0; i < Moments; i++) mean[i] = new double[length];
            Array.Fill(held, -1);
            column = new double[length + 2 * Radius * 3];
            window = new double[length];
        }

        /// <summary>The sum of the index over a line's bytes.</summary>
        public double SimilarityOf(int y)
        {
            for (var moment = 0; moment < Moments; moment++) Blur(y, moment);
            var sum = 0.0;
            for (var i = 0; i < length; i++)
            {
                var (mx, my) = (mean[0][i], mean[1][i]);
                var (vx, vy, vxy) = (mean[2][i] - mx * mx, mean[3][i] - my * my, mean[4][i] - mx * my);
                sum += (2 * mx * my + C1) * (2 * vxy + C2) / ((mx * mx + my * my + C1) * (vx + vy + C2));
            }
            return sum;
        }

        /// <summary>The weighted mean of a moment over the window around each byte of a line: first the columns, then along the line.</summary>
        private void Blur(int y, int moment)
        {
            var middle = column.AsSpan(Radius * 3, length);
            middle.Clear();
            for (var k = 0; k < Taps; k++)
                Add(weights[k], ring[Hold(Math.Clamp(y + k - Radius, 0, mine.Height - 1)) * Moments + moment], middle);
            for (var i = 0; i < Radius * 3; i++)
            {
                column[i] = middle[i % 3];
                column[^(i + 1)] = middle[^(i % 3 + 1)];
            }
            Array.Clear(window);
            for (var k = 0; k < Taps; k++) Add(weights[k], column.AsSpan(k * 3, length), window);
            window.CopyTo(mean[moment], 0);
        }

        /// <summary>The place of a line in the ring.</summary>
        private int Hold(int y)
        {
            var place = y % Taps;
            if (held[place] == y) return place;
            held[place] = y;
            var a = mine.Rgb.AsSpan(y * length, length);
            var b = reference.Rgb.AsSpan(y * length, length);
            for (var i = 0; i < length; i++)
            {
                double x1 = a[i], x2 = b[i];
                ring[place * Moments][i] = x1;
                ring[place * Moments + 1][i] = x2;
                ring[place * Moments + 2][i] = x1 * x1;
                ring[place * Moments + 3][i] = x2 * x2;
                ring[place * Moments + 4][i] = x1 * x2;
            }
            return place;
        }

        /// <summary>sum += weight · values.</summary>
        private static void Add(double weight, ReadOnlySpan<double> values, Span<double> sum)
        {
            var wide = MemoryMarshal.Cast<double, Vector<double>>(values);
            var wideSum = MemoryMarshal.Cast<double, Vector<double>>(sum);
            for (var i = 0; i < wideSum.Length; i++) wideSum[i] += weight * wide[i];
            for (var i = wideSum.Length * Vector<double>.Count; i < sum.Length; i++) sum[i] += weight * values[i];
        }
    }
}
