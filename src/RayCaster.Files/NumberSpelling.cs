using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>Numbers as other languages, programs and people write them.</summary>
internal static partial class NumberSpelling
{
    /// <summary>The number as all files have it; null where the text is none. A number that is right is returned as it is.</summary>
    /// <param name="isComma">Whether a comma may stand for the decimal point.</param>
    public static string? Correct(string text, bool isComma = false)
    {
        text = text.Replace("**", "^");
        if (Power().Match(Lookalike.ToAscii(text)) is { Success: true } power && text.AsSpan().IndexOfAny(Superscripts) > 0)
            return (power.Groups["factor"].Value is { Length: > 0 } factor ? factor : "1") + "e" + power.Groups["exponent"].Value.TrimStart('+');
        var number = Form().Match(text);
        if (!number.Success || (!isComma && number.Groups["point"].Value == ",")) return null;
        var sign = number.Groups["sign"].Value.EndsWith('-') ? "-" : "";
        var whole = Separators().Replace(number.Groups["whole"].Value, "");
        var fraction = Separators().Replace(number.Groups["fraction"].Value, "");
        if (whole.Length + fraction.Length == 0) return null;
        whole = whole.TrimStart('0');
        return sign + (whole.Length > 0 ? whole : "0") + (fraction.Length > 0 ? "." + fraction : "")
            + number.Groups["letter"].Value.Replace('d', 'e').Replace('D', 'E') + number.Groups["power"].Value;
    }

    /// <summary>What to write in place of a word of a mesh file that should be a number; empty if that is not known.</summary>
    public static string Hint(string word)
    {
        if (Lookalike.FindIn(word) is { } lookalike) return "; " + lookalike.Message;
        if (word.AsSpan().Trim('*').IsEmpty) return "; the number did not fit into the column of the program that wrote it";
        if (WithoutLetter().Match(word) is { Success: true } fortran) return $"; write {fortran.Groups[1].Value}E{fortran.Groups[2].Value}";
        if (Thousands().IsMatch(word)) return $"; write {word.Replace(",", "")}";
        var alone = word.TrimEnd(',', ';');
        var separators = SeparatorHint(alone.Length < word.Length || alone.Count(c => c is ',' or ';') > 1 || alone.Contains(';') ? word : "");
        var number = Correct(alone, isComma: true);
        if (number is null || number == alone) return separators;
        return alone.Contains(',') ? $"{separators}; is this a decimal comma? Write {number}" : $"{separators}; write {number}";
    }

    /// <summary>Where commas or semicolons separate numbers of a mesh: what should.</summary>
    public static string SeparatorHint(string word) =>
        word.Contains(';') ? "; blanks, not semicolons, separate numbers" : word.Contains(',') ? "; blanks, not commas, separate numbers" : "";

    private const string Superscripts = "^⁰¹²³⁴⁵⁶⁷⁸⁹";

    [GeneratedRegex(@"^((?<factor>-?[0-9]+(\.[0-9]+)?)[*x×.·])?10\^?(?<exponent>[+-]?[0-9]+)$")]
    private static partial Regex Power();

    [GeneratedRegex(@"^(?<sign>[+]*-?)(?<whole>[0-9][0-9_']*)?((?<point>[.,])(?<fraction>([0-9][0-9_]*)?))?((?<letter>[ed])(?<power>[+-]?[0-9]+))?"
        + "([fdlmu]|deg|°)?$", RegexOptions.IgnoreCase)] // Fortran's D, the suffixes of C# and Java, and degrees
    private static partial Regex Form();

    [GeneratedRegex(@"^([+-]?[0-9]*\.[0-9]*)([+-][0-9]+)$")] // as Fortran writes exponents of three digits: 2.5-101
    private static partial Regex WithoutLetter();

    [GeneratedRegex("[_']")]
    private static partial Regex Separators();

    [GeneratedRegex(@"^[+-]?[0-9]{1,3}(,[0-9]{3})+\.[0-9]+$")]
    private static partial Regex Thousands();
}
