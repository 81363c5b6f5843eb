using System.Globalization;

namespace RayCaster.Benchmarks;

/// <summary>Numbers as tables show them.</summary>
internal static class Text
{
    /// <summary>998000 as 998,000.</summary>
    public static string Count(long number) => number.ToString("N0", CultureInfo.InvariantCulture);

    /// <summary>Three digits: 12.3, 1.23, 0.123, 0.00012.</summary>
    public static string Ratio(double number)
    {
        if (number <= 0 || !double.IsFinite(number)) return "–";
        var decimals = Math.Clamp(2 - (int)Math.Floor(Math.Log10(number)), 0, 8);
        return number.ToString("F" + decimals, CultureInfo.InvariantCulture);
    }

    /// <summary>A ratio with its spread: the median, the quartiles and the ratio of the minima.</summary>
    public static string Spread(Ratio ratio) =>
        $"**{Ratio(ratio.Median)}** ({Ratio(ratio.LowerQuartile)}–{Ratio(ratio.UpperQuartile)}; {Ratio(ratio.OfMinima)})";
}
