using System.Globalization;
using System.Numerics;

namespace RayCaster.Tests.Accuracy;

/// <summary>Compares a double with a number of thirty digits, without rounding.</summary>
internal static class ExactDecimal
{
    /// <summary>How far a double is from the number, in units of the last place that a double near it has; 0 if both are 0.</summary>
    public static double Ulps(double t, string exact)
    {
        // exact = digits / tens; t = whole * 2^power.
        var parts = exact.Split('e');
        var point = parts[0].IndexOf('.');
        var digits = BigInteger.Parse(parts[0].Replace(".", ""), CultureInfo.InvariantCulture);
        var exponent = parts.Length > 1 ? int.Parse(parts[1], CultureInfo.InvariantCulture) : 0;
        if (point >= 0) exponent -= parts[0].Length - point - 1;
        var (tens, ours) = (BigInteger.One, new BigInteger(Math.ScaleB(t, 52 - (t == 0 ? 0 : Math.ILogB(t)))));
        if (exponent < 0) tens = BigInteger.Pow(10, -exponent);
        else digits *= BigInteger.Pow(10, exponent);
        if (digits == 0) return t == 0 ? 0 : double.PositiveInfinity;

        // Both in units of the double's last place there: |ours - exact| / 2^last, where 2^(last + 52) <= |exact| < 2^(last + 53).
        var last = Math.ILogB(double.Parse(exact, CultureInfo.InvariantCulture)) - 52;
        var power = t == 0 ? 0 : Math.ILogB(t) - 52;
        var least = Math.Min(Math.Min(last, power), 0);
        var difference = BigInteger.Abs(tens * ours * BigInteger.Pow(2, power - least) - digits * BigInteger.Pow(2, -least));
        return Quotient(difference, tens * BigInteger.Pow(2, last - least));
    }

    private static double Quotient(BigInteger a, BigInteger b) => (double)(a * BigInteger.Pow(2, 64) / b) / Math.ScaleB(1, 64);
}
