namespace RayCaster.Teaching.Comparison;

/// <summary>The right picture in fewer colours: 5, 6 and 5 bits, a palette, with or without dithering.</summary>
internal static class FewColors
{
    /// <summary>By how many levels a channel may differ on average and, where the picture is not dithered, anywhere. A step of two bits is 64 or
    /// 85.</summary>
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
        if (mine.IsNearlyOneColor || right.IsNearlyOneColor) return null;
        var (colors, all) = (ColorsOf(mine), ColorsOf(right));
        var isFewer = 10 * colors < 7 * all || (colors <= Palette && all > Palette);
        return isFewer && (IsCut(difference)
                || HasBothSigns(difference) && (IsRounded(difference, colors) || (colors <= Palette && IsDithered(difference))))
            ? $"The picture was saved with fewer colours: it has {Digits.Number(colors)}, the right one {Digits.Number(all)}. " +
                "The differences are those of rounding; the formulas are right."
            : null;
    }

    private static int ColorsOf(Picture picture) => Enumerable.Range(0, picture.Count).Select(picture.At).Distinct().Count();

    /// <summary>Whether each channel has a few values, and each pixel the one below the right value, or the nearest.</summary>
    private static bool IsCut(PictureDifference difference)
    {
        for (var channel = 0; channel < 3; channel++)
        {
            var values = new bool[256];
            for (var i = channel; i < difference.Mine.Rgb.Length; i += 3) values[difference.Mine.Rgb[i]] = true;
            var (wrong, cut) = (0, 0);
            for (var pixel = 0; pixel < difference.Pixels; pixel++)
            {
                var (shown, right) = (difference.Mine.Rgb[3 * pixel + channel], difference.Reference.Rgb[3 * pixel + channel]);
                if (Math.Abs(shown - right) <= PictureJudge.Tolerance) continue;
                wrong++;
                // Between the two lies no other value that the channel has.
                var between = Enumerable.Range(Math.Min(shown, right) + 1, Math.Abs(shown - right) - 1);
                if (Math.Abs(shown - right) <= Most && !between.Any(value => values[value] && Math.Abs(value - right) > 1)) cut++;
            }
            if (cut < Nearly * wrong) return false;
        }
        return true;
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
    private static bool IsRounded(PictureDifference difference, int colors)
    {
        var same = 0;
        var groups = Enumerable.Range(0, difference.Pixels).GroupBy(difference.Reference.At).ToArray();
        foreach (var group in groups)
        {
            var most = group.CountBy(difference.Mine.At).MaxBy(color => color.Value);
            if (PictureDifference.Levels(most.Key, group.Key) <= Most) same += most.Value;
        }
        return difference.MeanAbsoluteError <= MostOnAverage && same >= Nearly * difference.Pixels && groups.Length > 2 * colors;
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
