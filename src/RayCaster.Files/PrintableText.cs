namespace RayCaster.Files;

/// <summary>Makes foreign text, such as a file's content or name, safe for a message.</summary>
internal static class PrintableText
{
    /// <summary>The text with U+FFFD in place of each character that is not printable; tabs stay.</summary>
    /// <param name="ofLines">Whether line ends stay, too.</param>
    public static string From(string text, bool ofLines = false)
    {
        var shown = text.ToCharArray();
        for (var i = 0; i < shown.Length; i++)
            if (!IsPrintable(text[i]) && text[i] != '\t' && !(ofLines && text.AsSpan(i) is ['\n', ..] or ['\r', '\n', ..]))
                shown[i] = '\uFFFD';
        return new(shown);
    }

    /// <summary>The text with invisible characters as JSON can write them: <c>\t</c>, <c>\u2060</c>.</summary>
    internal static string Escaped(string text) => string.Concat(text.Select(c =>
        c is >= '\b' and <= '\r' ? $"\\{"btnvfr"[c - '\b']}"
        : char.GetUnicodeCategory(c) == UnicodeCategory.Format ? $"\\u{(int)c:X4}" : From($"{c}")));

    /// <summary>False for characters that could move a terminal's cursor, end a line, or turn the direction of a text (Unicode's
    /// Bidi_Control).</summary>
    public static bool IsPrintable(char c) =>
        !char.IsControl(c)
        && c is not ('\u061C' or '\u200E' or '\u200F' or '\u2028' or '\u2029' or (>= '\u202A' and <= '\u202E') or (>= '\u2066' and <= '\u2069'));
}
