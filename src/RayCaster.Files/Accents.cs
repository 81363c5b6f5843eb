namespace RayCaster.Files;

/// <summary>Compares names in which é is one character, or e and an accent. (Without ICU the runtime does not normalise texts.)</summary>
internal static class Accents
{
    /// <summary>Of each mark, the letters with it and the same letters without it.</summary>
    private static readonly Dictionary<char, (char Base, char Mark)> marked = new (char Mark, string With, string Without)[]
    {
        ('\u0300', "ÀÈÌÒÙàèìòùǛǜ", "AEIOUaeiouÜü"),
        ('\u0301', "ÁÉÍÓÚÝáéíóúýĆćĹĺŃńŔŕŚśŹźǗǘ", "AEIOUYaeiouyCcLlNnRrSsZzÜü"),
        ('\u0302', "ÂÊÎÔÛâêîôûĈĉĜĝĤĥĴĵŜŝŴŵŶŷ", "AEIOUaeiouCcGgHhJjSsWwYy"),
        ('\u0303', "ÃÑÕãñõĨĩŨũ", "ANOanoIiUu"),
        ('\u0304', "ĀāĒēĪīŌōŪūǕǖ", "AaEeIiOoUuÜü"),
        ('\u0306', "ĂăĔĕĞğĬĭŎŏŬŭ", "AaEeGgIiOoUu"),
        ('\u0307', "ĊċĖėĠġİŻż", "CcEeGgIZz"),
        ('\u0308', "ÄËÏÖÜäëïöüÿŸ", "AEIOUaeiouyY"),
        ('\u030A', "ÅåŮů\u212B", "AaUuA"), // the last is the sign of the ångström
        ('\u030B', "ŐőŰű", "OoUu"),
        ('\u030C', "ČčĎďĚěĽľŇňŘřŠšŤťŽžǍǎǏǐǑǒǓǔǙǚǦǧ", "CcDdEeLlNnRrSsTtZzAaIiOoUuÜüGg"),
        ('\u0326', "ȘșȚț", "SsTt"),
        ('\u0327', "ÇçĢģĶķĻļŅņŖŗŞşŢţ", "CcGgKkLlNnRrSsTt"),
        ('\u0328', "ĄąĘęĮįŲų", "AaEeIiUu"),
    }.SelectMany(row => row.With.Zip(row.Without, (letter, without) => KeyValuePair.Create(letter, (without, row.Mark)))).ToDictionary();

    /// <summary>Whether two names differ at most in how their accents are encoded. A letter with marks that is none of the above is any one letter
    /// beyond ASCII.</summary>
    public static bool AreEquivalent(string one, string other)
    {
        if (Ascii.IsValid(one) && Ascii.IsValid(other)) return one == other; // most names, and quickly: a class is compared in pairs
        var (a, b) = (Apart(one), Apart(other));
        var (i, j) = (0, 0);
        while (i < a.Length && j < b.Length)
        {
            var x = a.AsSpan(i, StringInfo.GetNextTextElementLength(a.AsSpan(i)));
            var y = b.AsSpan(j, StringInfo.GetNextTextElementLength(b.AsSpan(j)));
            if (!x.SequenceEqual(y) && !(HasMark(x) && IsLetter(y)) && !(HasMark(y) && IsLetter(x))) return false;
            (i, j) = (i + x.Length, j + y.Length);
        }
        return i == a.Length && j == b.Length;
    }

    /// <summary>A name whose letters stand before their marks, and Korean syllables as their two or three parts.</summary>
    private static string Apart(string name) => string.Concat(name.Select(Apart));

    private static string Apart(char letter)
    {
        if (marked.TryGetValue(letter, out var parts)) return Apart(parts.Base) + parts.Mark;
        if (letter is < '\uAC00' or > '\uD7A3') return $"{letter}";
        var (initial, rest) = Math.DivRem(letter - 0xAC00, 21 * 28);
        var (vowel, final) = Math.DivRem(rest, 28);
        return $"{(char)(0x1100 + initial)}{(char)(0x1161 + vowel)}{(final > 0 ? (char)(0x11A7 + final) : "")}";
    }

    private static bool HasMark(ReadOnlySpan<char> element) =>
        element.Length > 1 && CharUnicodeInfo.GetUnicodeCategory(element[1]) == UnicodeCategory.NonSpacingMark;

    private static bool IsLetter(ReadOnlySpan<char> element) => element is [> '\x7F' and var letter] && char.IsLetter(letter);
}
