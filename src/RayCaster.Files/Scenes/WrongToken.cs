namespace RayCaster.Files;

/// <summary>Finds the mistake in a word, a number or a text that is not JSON. Each method returns null if there is none, or if the file ends too
/// early.</summary>
internal readonly ref struct WrongToken(SourceText text)
{
    private readonly ReadOnlySpan<byte> utf8 = text.Utf8;
    private readonly JsonWords words = new(text);

    public JsonMistake? Number(int at)
    {
        var (word, end, digits) = (words.Word(at), words.End(at), at);
        if (IsNotFinite(word)) return NotFinite(at);
        if (utf8[at] == '+') return Corrected("a number has no plus sign: write");
        if (utf8[at] == '-') digits++;
        if (digits < end && utf8[digits] == '.') return Corrected("a number needs a digit before the point:");
        if (!words.IsDigit(digits)) return new(at, Math.Max(end, at + 1), "a digit must follow the minus sign");
        if (utf8[digits] == '0' && words.IsDigit(digits + 1)) return Corrected("a number does not begin with 0: write");
        if (utf8[digits] == '0' && digits + 1 < end && (utf8[digits + 1] | 0x20) == 'x') return new(at, end, $"numbers are decimal; {word} is not");

        var i = SkipDigits(digits);
        if (i < end && utf8[i] == '.')
        {
            if (!words.IsDigit(++i) && i < utf8.Length) return new(at, end, "a digit must follow the point of a number, or leave the point out");
            i = SkipDigits(i);
        }
        if (i < end && (utf8[i] | 0x20) == 'e')
        {
            i++;
            if (i < end && utf8[i] is (byte)'+' or (byte)'-') i++;
            if (!words.IsDigit(i) && i < utf8.Length) return new(at, end, "a digit must follow the e of a number: 1e-6");
            i = SkipDigits(i);
        }
        return i == end ? null : new(at, end, $"{word} is not a number; a number ends before {Shown(words.Character(i))}");

        JsonMistake Corrected(string advice)
        {
            var sign = word[0] == '-' ? "-" : "";
            var rest = word.TrimStart('+', '-').TrimStart('0');
            var number = sign + (rest.Length == 0 || !char.IsAsciiDigit(rest[0]) ? "0" : "") + rest;
            return new(at, end, IsNumber(number) ? $"{advice} {number}" : $"{word} is not a number");
        }
    }

    /// <summary>A word without quotes, where a value should be.</summary>
    public JsonMistake? Literal(int at)
    {
        var (word, end) = (words.Word(at), words.End(at));
        foreach (var literal in (ReadOnlySpan<string>)["true", "false", "null"])
        {
            if (literal == word || (end == utf8.Length && literal.StartsWith(word, StringComparison.Ordinal))) return null;
            if (literal.Equals(word, StringComparison.OrdinalIgnoreCase)) return new(at, end, $"{word} is written {literal} in JSON");
        }
        if (IsNotFinite(word)) return NotFinite(at);
        return char.IsLetter(word[0]) || word[0] == '_'
            ? new(at, end, $"{word} is not a value; a text is written in double quotes: \"{word}\"")
            : new(at, end, $"a value is expected here, not {Shown(words.Character(at))}");
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
        var c = words.Character(at);
        if (c.Value is '“' or '”' or '„' or '«' or '»' or '‘' or '’')
            return new(at, words.End(at), $"texts and keys are written in straight double quotes \", not in {c}");
        if (IsInvisible(c))
            return new(at, at + c.Utf8SequenceLength, $"the character {Shown(c)} looks like a space or like nothing, "
                + "but only a plain space is allowed here");
        return null;
    }

    private JsonMistake NotFinite(int at) => new(at, words.End(at), $"{words.Word(at)} is not allowed; a number must be finite");

    private int SkipDigits(int at)
    {
        while (words.IsDigit(at)) at++;
        return at;
    }

    private static bool IsNotFinite(string word) => word.TrimStart('+', '-').ToLowerInvariant() is "nan" or "inf" or "infinity";

    private static bool IsNumber(string word)
    {
        var reader = new Utf8JsonReader(Encoding.UTF8.GetBytes(word));
        try
        {
            return reader.Read() && reader.TokenType == JsonTokenType.Number && reader.BytesConsumed == word.Length && !reader.Read();
        }
        catch (JsonException)
        {
            return false;
        }
    }

    private static bool IsInvisible(Rune c) => !c.IsAscii && (Rune.IsWhiteSpace(c) || Rune.GetUnicodeCategory(c) == UnicodeCategory.Format);

    /// <summary>A character in quotes; an invisible one by its number.</summary>
    private static string Shown(Rune c) => IsInvisible(c) ? $"U+{c.Value:X4}" : $"'{c}'";
}
