using System.Text.RegularExpressions;

namespace RayCaster.Files;

/// <summary>Finds the words, numbers and texts of a text that is not JSON, and the mistake in one: null if there is none, or if the file ends
/// too early.</summary>
internal readonly ref struct JsonWords(SourceText text)
{
    /// <summary>How numbers are wrong, and messages with the word and the right number. Unless it ends the file, a blank follows.</summary>
    private static readonly (string Pattern, string Message)[] wrongNumbers =
    [
        (@"^\+", "a number has no plus sign: write {1}"),
        (@"^-?\.", "a number needs a digit before the point: {1}"),
        ("^-(?![0-9])", "a digit must follow the minus sign"),
        ("^-?0[0-9]", "a number does not begin with 0: write {1}"),
        ("^-?0x", "numbers are decimal; {0} is not"),
        (@"^-?[0-9]+\.(?![0-9]|$)", "a digit must follow the point of a number, or leave the point out"),
        (@"^-?[0-9]+(\.[0-9]+)?e[+-]?(?![0-9+-]|$)", "a digit must follow the e of a number: 1e-6"),
    ];

    private readonly ReadOnlySpan<byte> utf8 = text.Utf8;

    /// <summary>The next place that holds neither a blank nor a comment. A comment that is not closed is not skipped.</summary>
    public int SkipBlanks(int at)
    {
        while (at < utf8.Length)
        {
            var end = utf8[at] is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' ? at + 1 : EndOfComment(at);
            if (end == at) break;
            at = end;
        }
        return at;
    }

    public bool IsDigit(int at) => at < utf8.Length && utf8[at] is >= (byte)'0' and <= (byte)'9';

    public int LineEnd(int at) => utf8[at..].IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? at + length : utf8.Length;

    /// <summary>The end of what looks like one word or number, at least one byte further.</summary>
    public int End(int at) => utf8[at..].IndexOfAny(" \t\r\n,:;[]{}/=\""u8) switch
    {
        < 0 => utf8.Length,
        0 => at + 1,
        var length => at + length,
    };

    public string Word(int at) => text.Quote(at, End(at));

    public Rune Character(int at)
    {
        Rune.DecodeFromUtf8(utf8[at..], out var character, out _);
        return character;
    }

    /// <summary>The place after the comment that begins at a place. The place itself where no comment begins, or where one is not closed.</summary>
    private int EndOfComment(int at)
    {
        var text = utf8[at..];
        if (text.StartsWith("//"u8)) return at + (text.IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? length : text.Length);
        return text.StartsWith("/*"u8) && text[2..].IndexOf("*/"u8) is >= 0 and var inner ? at + inner + 4 : at;
    }

    public JsonMistake? Number(int at)
    {
        var word = Word(at);
        var end = End(at);
        if (IsNotFinite(word)) return NotFinite(at);
        var text = Encoding.UTF8.GetString(utf8[at..end]);
        foreach (var (pattern, message) in wrongNumbers)
            if (Regex.IsMatch(end < utf8.Length ? text + " " : text, pattern, RegexOptions.IgnoreCase))
                return new(at, end, message.Contains("{1}") && Corrected(word) is null ? $"{word} is not a number"
                    : string.Format(null, message, word, Corrected(word)));
        var length = Regex.Match(text, "^-?[0-9]+(\\.[0-9]*)?(e[+-]?[0-9]*)?", RegexOptions.IgnoreCase).Length;
        return length == text.Length ? null
            : new(at, end, $"{word} is not a number; a number ends before {Shown(Character(at + length))}");
    }

    /// <summary>A word as a number without a plus sign, with one digit or more before the point; null where that is none.</summary>
    private static string? Corrected(string word)
    {
        var rest = word.TrimStart('+', '-').TrimStart('0');
        var number = (word[0] == '-' ? "-" : "") + (rest.Length == 0 || !char.IsAsciiDigit(rest[0]) ? "0" : "") + rest;
        return Regex.IsMatch(number, "^-?(0|[1-9][0-9]*)(\\.[0-9]+)?(e[+-]?[0-9]+)?$", RegexOptions.IgnoreCase) ? number : null;
    }

    /// <summary>A word without quotes, where a value should be.</summary>
    public JsonMistake? Literal(int at)
    {
        var word = Word(at);
        var end = End(at);
        foreach (var literal in (ReadOnlySpan<string>)["true", "false", "null"])
        {
            if (literal == word || (end == utf8.Length && literal.StartsWith(word, StringComparison.Ordinal))) return null;
            if (literal.Equals(word, StringComparison.OrdinalIgnoreCase)) return new(at, end, $"{word} is written {literal} in JSON");
        }
        if (IsNotFinite(word)) return NotFinite(at);
        return char.IsLetter(word[0]) || word[0] == '_'
            ? new(at, end, $"{word} is not a value; a text is written in double quotes: \"{word}\"")
            : new(at, end, $"a value is expected here, not {Shown(Character(at))}");
    }

    /// <summary>A text in double quotes.</summary>
    public JsonMistake? Text(int at, out int end)
    {
        for (end = at + 1; end < utf8.Length; end++)
        {
            var c = utf8[end];
            if (c == '"')
            {
                end++;
                return null;
            }
            if (c is (byte)'\r' or (byte)'\n') return new(at, end, "this text is not closed in its line; a double quote is missing");
            if (c < 0x20)
                return new(end, end + 1, c == '\t' ? "a tab in a text is written \\t" : $"a text cannot hold the control character {c:X4}");
            if (c != '\\' || ++end == utf8.Length) continue;
            var start = end - 1;
            if (!"\"\\/bfnrtu"u8.Contains(utf8[end]))
                return new(start, end + 1, "a backslash in a text is written twice: \\\\ (a path may have / instead)");
            for (var left = utf8[end] == 'u' ? 4 : 0; left > 0 && end + 1 < utf8.Length; left--)
                if (!char.IsAsciiHexDigit((char)utf8[++end]))
                    return new(start, end, "four hexadecimal digits must follow \\u");
        }
        end = utf8.Length;
        return new(end, end, $"the file ends too early: the text that begins in line {text.LineOf(at)} is never closed");
    }

    /// <summary>A character that comes with text copied from a page or a word processor.</summary>
    public JsonMistake? Lookalike(int at)
    {
        var c = Character(at);
        if (c.Value is '“' or '”' or '„' or '«' or '»' or '‘' or '’')
            return new(at, End(at), $"texts and keys are written in straight double quotes \", not in {c}");
        if (IsInvisible(c))
            return new(at, at + c.Utf8SequenceLength, $"the character {Shown(c)} looks like a space or like nothing, "
                + "but only a plain space is allowed here");
        return null;
    }

    private JsonMistake NotFinite(int at) => new(at, End(at), $"{Word(at)} is not allowed; a number must be finite");

    private static bool IsNotFinite(string word) => word.TrimStart('+', '-').ToLowerInvariant() is "nan" or "inf" or "infinity";

    private static bool IsInvisible(Rune c) => !c.IsAscii && (Rune.IsWhiteSpace(c) || Rune.GetUnicodeCategory(c) == UnicodeCategory.Format);

    /// <summary>A character in quotes; an invisible one by its number.</summary>
    private static string Shown(Rune c) => IsInvisible(c) ? $"U+{c.Value:X4}" : $"'{c}'";
}
