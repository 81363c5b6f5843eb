namespace RayCaster.Teaching;

/// <summary>Numbers for people: six significant digits, a true minus sign.</summary>
internal static class Digits
{
    public static string Of(double value) => Of(value, 6);

    /// <summary>A number for one value, a vector for three.</summary>
    public static string Of(IReadOnlyList<double> values) =>
        values is [var only] ? Of(only) : $"({string.Join(", ", values.Select(value => Of(value)))})";

    public static string Of(Vector3 v) => Of([v.X, v.Y, v.Z]);

    public static string Of(Color color) => Of([color.R, color.G, color.B]);

    /// <summary>Two numbers, with enough digits to show their difference.</summary>
    public static (string A, string B) Apart(double a, double b)
    {
        var digits = 6;
        while (a != b && Of(a, digits) == Of(b, digits) && digits < 17) digits++;
        return (Of(a, digits), Of(b, digits));
    }

    private static string Of(double value, int digits)
    {
        if (double.IsNaN(value)) return "NaN";
        if (double.IsInfinity(value)) return value > 0 ? "∞" : "−∞";
        var text = value.ToString("G" + digits.ToString(CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
        if (text == "-0") text = "0";
        if (text.IndexOf('E') is var e and > 0)
        {
            var exponent = int.Parse(text.AsSpan(e + 1), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture);
            text = string.Create(CultureInfo.InvariantCulture, $"{text[..e]}e{exponent}");
        }
        return text.StartsWith('-') ? $"−{text[1..]}" : text;
    }
}
