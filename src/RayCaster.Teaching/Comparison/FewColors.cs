namespace RayCaster.Teaching.Comparison;

/// <summary>The right picture in fewer colours: 5, 6 and 5 bits, a palette, with or without dithering.</summary>
internal static class FewColors
{
    /// <summary>By how many levels a channel may differ on average and, where the picture is not dithered, anywhere: half of a step of 85, and of
    /// the least step that two bits leave.</summary>
    private const int MostOnAverage = 24, Most = 64;

    /// <summary>A palette has at most so many colours.</summary>
    private const int Palette = 256;

    /// <summary>The share of pixels that must agree; the others lie on outlines.</summary>
    private const double Nearly = 0.97;

    /// <summary>The side of the areas whose means must agree if the picture is dithered.</summary>
    private const int Side = 8;

    /// <summary>A sentence if a picture is the right one in fewer colours; otherwise null.</summary>
    public static string? Find(PictureDifference difference)
    {
        var (mine, right) = (difference.Mine, difference.Reference);
        if (mine.IsNearlyOneColor || right.IsNearlyOneColor || difference.MeanAbsoluteError > MostOnAverage) return null;
        var colors = ColorsOf(mine);
        if (Bits(difference) is { } bits)
            return $"The colours are the right ones with fewer bits: its channels have {bits}. The picture was saved with fewer colours; " +
                "the formulas are right.";
        var all = ColorsOf(right);
        var isFewer = 10 * colors < 7 * all || (colors <= Palette && all > Palette);
        if (!isFewer || !HasBothSigns(difference)) return null;
        return IsFunction(difference, colors) || (colors <= Palette && IsDithered(difference))
            ? $"The picture was saved with fewer colours: it has {colors}, the right one {Digits.Number(all)}, and all differences are those of " +
                "rounding to the nearest of them. The formulas are right."
            : null;
    }

    private static int ColorsOf(Picture picture) => Enumerable.Range(0, picture.Count).Select(picture.At).Distinct().Count();

    /// <summary>How many values each channel has, if each of its values stands for a range of equal length; null if not.</summary>
    private static string? Bits(PictureDifference difference)
    {
        var bits = new int[3];
        for (var channel = 0; channel < 3; channel++)
        {
            bits[channel] = Enumerable.Range(2, 6).Reverse().FirstOrDefault(count => Fits(channel, count));
            if (bits[channel] == 0 && Fits(channel, 8)) bits[channel] = 8;
            if (bits[channel] == 0) return null;
        }
        return bits.Min() == 8 ? null : $"{bits[0]}, {bits[1]} and {bits[2]} bits";

        bool Fits(int channel, int count)
        {
            var fits = 0;
            for (var i = channel; i < difference.Mine.Rgb.Length; i += 3)
            {
                var (shown, right) = (difference.Mine.Rgb[i], difference.Reference.Rgb[i]);
                if (Enumerable.Range(-1, 3).Any(level => IsOf(shown, Math.Clamp(right + level, 0, 255)))) fits++;
            }
            return fits >= Nearly * difference.Pixels;

            // cut or rounded, and widened again by zeros, by its own bits, or by a factor
            bool IsOf(byte shown, int right)
            {
                var rest = 8 - count;
                var most = (1 << count) - 1;
                var cut = right >> rest;
                return shown == cut << rest || shown == (cut << rest | (cut << rest) >> count)
                    || Math.Abs(shown - cut * 255.0 / most) < 1 || Math.Abs(shown - Math.Round(right * most / 255.0) * 255.0 / most) < 1;
            }
        }
    }

    /// <summary>Whether there are channels that are too bright, and such that are too dark.</summary>
    private static bool HasBothSigns(PictureDifference difference)
    {
        var (brighter, darker) = (0, 0);
        foreach (var (shown, right) in difference.Mine.Rgb.Zip(difference.Reference.Rgb))
        {
            if (shown > right) brighter++;
            else if (shown < right) darker++;
        }
        return 8 * Math.Min(brighter, darker) > Math.Max(brighter, darker);
    }

    /// <summary>Whether each colour of the right picture has become one colour, in small steps.</summary>
    private static bool IsFunction(PictureDifference difference, int colors)
    {
        var same = 0;
        var groups = Enumerable.Range(0, difference.Pixels).GroupBy(difference.Reference.At).ToArray();
        foreach (var group in groups)
        {
            var most = group.CountBy(difference.Mine.At).MaxBy(color => color.Value);
            if (PictureDifference.Levels(most.Key, group.Key) <= Most) same += most.Value;
        }
        return same >= Nearly * difference.Pixels && groups.Length > 2 * colors;
    }

    /// <summary>Whether the means of small areas agree much better than their pixels.</summary>
    private static bool IsDithered(PictureDifference difference)
    {
        double ofPixels = 0, ofAreas = 0;
        for (var top = 0; top + Side <= difference.Mine.Height; top += Side)
        {
            for (var left = 0; left + Side <= difference.Mine.Width; left += Side)
            {
                for (var channel = 0; channel < 3; channel++)
                {
                    var sum = 0;
                    for (var y = top; y < top + Side; y++)
                    {
                        for (var x = left; x < left + Side; x++)
                        {
                            var i = 3 * (y * difference.Mine.Width + x) + channel;
                            var levels = difference.Mine.Rgb[i] - difference.Reference.Rgb[i];
                            ofPixels += Math.Abs(levels);
                            sum += levels;
                        }
                    }
                    ofAreas += Math.Abs(sum);
                }
            }
        }
        return ofPixels > 0 && ofAreas <= 0.4 * ofPixels;
    }
}
