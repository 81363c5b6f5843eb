namespace RayCaster.Teaching;

/// <summary>Numbers for people: six significant digits, a true minus sign.</summary>
internal static class Digits
{
    private static readonly NumberFormatInfo format = new()
    {
        NegativeSign = "−",
        PositiveInfinitySymbol = "∞",
        NegativeInfinitySymbol = "−∞",
    };

    public static string Of(double value) => Of(value, 6);

    public static string Of(Vector3 v) => $"({Of(v.X)}, {Of(v.Y)}, {Of(v.Z)})";

    public static string Of(Color color) => Of(new Vector3(color.R, color.G, color.B));

    /// <summary>Two numbers, with enough digits to show their difference.</summary>
    public static (string A, string B) Apart(double a, double b)
    {
        var digits = 6;
        while (a != b && Of(a, digits) == Of(b, digits) && digits < 17) digits++;
        return (Of(a, digits), Of(b, digits));
    }

    /// <summary>0 for −0, and 1e-7 for 1E−07.</summary>
    private static string Of(double value, int digits) => (value + 0).ToString($"G{digits}", format)
        .Replace("E+0", "e").Replace("E+", "e").Replace("E−0", "e-").Replace("E−", "e-");
}
