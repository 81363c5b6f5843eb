namespace RayCaster.Files;

/// <summary>Characters of slides, web pages and word processors that look like ASCII.</summary>
internal static class Lookalike
{
    private static readonly (string Characters, string Ascii, string Name)[] kinds =
    [
        ("−", "-", "the minus of word processors"),
        ("‐‑‒–—―⁃˗﹘﹣", "-", "a dash of word processors"),
        ("⁻₋", "-", "a superscript or subscript minus"),
        ("⁺₊", "+", "a superscript or subscript plus"),
        ("“”„‟«»″〝〞‘’‚‛‹›′´", "\"", "a quote of word processors"),
        ("、،", ",", "a comma of another script"),
        ("؛", ";", "a semicolon of another script"),
        ("。٫·", ".", "a point of another script"),
        ("﹕∶", ":", "a colon of another script"),
        ("【〔〖", "[", "a bracket of another script"),
        ("】〕〗", "]", "a bracket of another script"),
        ("⁄∕", "/", "a slash of word processors"),
    ];

    /// <summary>What a character is, and what to write: <c>− is U+2212, the minus of word processors: write -</c>. Null for ASCII and for
    /// characters that look like nothing else.</summary>
    public static string? Describe(Rune c)
    {
        if (c.IsAscii) return null;
        if (Rune.IsWhiteSpace(c)) return $"U+{c.Value:X4} is a space of word processors and web pages: write a plain space";
        if (Rune.GetUnicodeCategory(c) == UnicodeCategory.Format) return $"U+{c.Value:X4} is an invisible character: remove it";
        return Meaning(c) is var (ascii, name) ? $"{c} is U+{c.Value:X4}, {name}: write {ascii}" : null;
    }

    public static (int Index, string Message)? FindIn(string text)
    {
        var index = 0;
        foreach (var c in text.EnumerateRunes())
        {
            if (Describe(c) is { } message) return (index, message);
            index += c.Utf16SequenceLength;
        }
        return null;
    }

    /// <summary>The text with ASCII in place of such characters; spaces and invisible characters stay.</summary>
    public static string ToAscii(string text) =>
        string.Concat(text.EnumerateRunes().Select(c => c.IsAscii ? $"{c}" : Meaning(c)?.Ascii ?? $"{c}"));

    private static (string Ascii, string Name)? Meaning(Rune c)
    {
        foreach (var (characters, ascii, name) in kinds)
            if (c.IsBmp && characters.Contains((char)c.Value)) return (ascii, name);
        if (c.Value is >= 0xFF01 and <= 0xFF5E) return ($"{(char)(c.Value - 0xFF01 + '!')}", "a full-width character");
        return Rune.GetNumericValue(c) is >= 0 and var number && Rune.GetUnicodeCategory(c) != UnicodeCategory.LetterNumber
            ? (number.ToString("0.####", CultureInfo.InvariantCulture),
                number is >= 1 or 0 ? "a digit that is not ASCII" : "a fraction in one character")
            : null;
    }
}
