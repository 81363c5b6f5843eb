using System.Buffers;
using System.Globalization;

namespace RayCaster;

/// <summary>Reads decimal numbers as people and programs write them: <c>1</c>, <c>+1.5</c>, <c>.5</c>, <c>5.</c>, <c>-1.5E+3</c>.</summary>
internal static class DecimalNumber
{
    private const NumberStyles styles = NumberStyles.AllowLeadingSign | NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent;
    private static readonly SearchValues<byte> allowed = SearchValues.Create("0123456789+-.eE"u8);

    /// <summary>Reads a word as the double nearest to it; false where it is no number or beyond the largest double.</summary>
    public static bool TryParse(ReadOnlySpan<byte> word, out double number)
    {
        number = 0;
        return !word.ContainsAnyExcept(allowed) // no "Infinity", and no zero bytes, which the platform forgives
            && double.TryParse(word, styles, CultureInfo.InvariantCulture, out number)
            && double.IsFinite(number);
    }
}
