namespace RayCaster.Files;

/// <summary>Numbers for people: doubles with six significant digits and a true minus sign, counts, shares.</summary>
internal static class Digits
{
    private static readonly NumberFormatInfo format = new()
    {
        NegativeSign = "−",
        PositiveInfinitySymbol = "∞",
        NegativeInfinitySymbol = "−∞",
    };

    /// <summary>"−1.5", "∞", "1e-7".</summary>
    public static string Format(double value) => Format(value, 6);

    /// <summary>"(1, 2, −3)".</summary>
    public static string Format(Vector3 v) => $"({Format(v.X)}, {Format(v.Y)}, {Format(v.Z)})";

    /// <summary>"(1, 0.5, 0)": red, green, blue.</summary>
    public static string Format(Color color) => Format(new Vector3(color.R, color.G, color.B));

    /// <summary>Two numbers, with enough digits to show their difference.</summary>
    public static (string A, string B) Apart(double a, double b)
    {
        var digits = 6;
        while (a != b && Format(a, digits) == Format(b, digits) && digits < 17) digits++;
        return (Format(a, digits), Format(b, digits));
    }

    /// <summary>"3 of 1,000 pixels (0.3 %)".</summary>
    public static string Part(int part, int whole) => $"{Number(part)} of {Count(whole, "pixel")} ({Share(part, whole)})";

    /// <summary>"1 vertex", "1,000 vertices".</summary>
    public static string Count(long number, string what) =>
        $"{Number(number)} {(number == 1 ? what : what == "vertex" ? "vertices" : what + "s")}";

    public static string Number(long number) => number.ToString("N0", CultureInfo.InvariantCulture);

    /// <summary>A share in percent; "100 %" only for all, and "0 %" only for none.</summary>
    public static string Share(int part, int whole)
    {
        if (part == whole) return "100 %";
        var percent = 100.0 * part / whole;
        return percent is > 0 and < 0.01 ? "less than 0.01 %" : $"{Math.Min(percent, 99.99).ToString("0.##", CultureInfo.InvariantCulture)} %";
    }

    /// <summary>0 for −0, and 1e-7 for 1E−07.</summary>
    private static string Format(double value, int digits) => (value + 0).ToString($"G{digits}", format)
        .Replace("E+0", "e").Replace("E+", "e").Replace("E−0", "e-").Replace("E−", "e-");
}
