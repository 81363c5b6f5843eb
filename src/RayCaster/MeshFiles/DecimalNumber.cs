using System.Buffers;
using System.Globalization;

namespace RayCaster;

/// <summary>Reads decimal numbers as people and programs write them: <c>1</c>, <c>+1.5</c>, <c>.5</c>, <c>5.</c>, <c>-1.5E+3</c>.</summary>
internal static class DecimalNumber
{
    private const NumberStyles styles = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
    private const int MostShort = 19; // so many digits fit into 64 bits
    private static readonly double[] powersOfTen =
        [1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18];
    private static readonly SearchValues<byte> allowed = SearchValues.Create("0123456789+-.eE"u8);

    /// <summary>Reads a word as the double nearest to it; false where it is no number or beyond the largest double.</summary>
    public static bool TryParse(ReadOnlySpan<byte> word, out double number)
    {
        if (TryParseShort(word, out number)) return true;
        return !word.ContainsAnyExcept(allowed) // no "Infinity", and no zero bytes, which the platform forgives
            && double.TryParse(word, styles, CultureInfo.InvariantCulture, out number)
            && double.IsFinite(number);
    }

    /// <summary>Reads a number that has no exponent and few digits, as most have; false for any other, and for what is no number.</summary>
    /// <remarks>
    /// Its digits are a whole number below 2⁵³, which is a double, and so is a power of ten up to 10²². Their quotient is rounded once, so it is the double
    /// nearest to what is written (Clinger, "How to Read Floating Point Numbers Accurately", 1990).
    /// </remarks>
    public static bool TryParseShort(ReadOnlySpan<byte> word, out double number)
    {
        number = 0;
        var isNegative = !word.IsEmpty && word[0] == '-';
        if (isNegative) word = word[1..];
        if (word.Length is 0 or > MostShort || !char.IsAsciiDigit((char)word[0])) return false;
        var (digits, decimals, isDecimal) = (0UL, 0, false);
        foreach (var c in word)
        {
            if (c == '.' && !isDecimal)
            {
                isDecimal = true;
                continue;
            }
            if (!char.IsAsciiDigit((char)c)) return false;
            digits = 10 * digits + (uint)(c - '0');
            if (isDecimal) decimals++;
        }
        if (digits >= 1UL << 53) return false;
        number = digits / powersOfTen[decimals];
        if (isNegative) number = -number;
        return true;
    }
}
