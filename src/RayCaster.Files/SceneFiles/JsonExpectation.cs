using System.Text;
using System.Text.Json;

namespace RayCaster.Files;

/// <summary>
/// Says in words why a JSON text breaks off: knows where the last good token ends and what may follow it, and looks at what does follow.
/// Runs only when the JSON reader has refused the text.
/// </summary>
/// <param name="tree">What was read until then.</param>
/// <param name="open">The arrays and objects that are open there.</param>
/// <param name="last">The last good token.</param>
/// <param name="lastEnd">The place after it; after a key that of its colon.</param>
internal readonly ref struct JsonExpectation(JsonTree tree, ReadOnlySpan<int> open, JsonTokenType last, int lastEnd)
{
    private readonly ReadOnlySpan<byte> utf8 = tree.Text.Utf8;

    private readonly ReadOnlySpan<int> open = open;

    private bool InObject => open.Length > 0 && tree[open[^1]].Kind == JsonTokenType.StartObject;

    /// <summary>Finds the mistake.</summary>
    /// <param name="refusal">What the JSON reader says, for what nobody thought of.</param>
    public JsonMistake Explain(JsonException refusal)
    {
        var at = SkipBlanks(lastEnd);
        if (at == utf8.Length && last == JsonTokenType.None) return new(at, at, "the file is empty; a scene is an object in braces { }");
        if (at == utf8.Length) return CutOff();

        return last switch
        {
            JsonTokenType.None => Value(at),
            JsonTokenType.PropertyName => Value(at),
            JsonTokenType.StartObject => Key(at),
            JsonTokenType.StartArray => Value(at),
            _ => AfterValue(at, lastEnd),
        } ?? Fallback(refusal);
    }

    private JsonMistake? AfterValue(int at, int valueEnd)
    {
        if (Lookalike(at) is { } lookalike) return lookalike;
        if (utf8[at] == '/') return last == JsonTokenType.Number && at == valueEnd && IsDigit(at + 1) ? Fraction(at) : Slash(at);
        if (open.Length == 0) return new(at, LineEnd(at), "the scene has ended before this; a file holds one object");
        if (utf8[at] == ',')
        {
            var next = SkipBlanks(at + 1);
            if (next == utf8.Length) return CutOff();
            return InObject ? Key(next) : Value(next);
        }
        if (utf8[at] is (byte)'}' or (byte)']') return WrongBracket(at);
        if (utf8[at] == ';') return new(at, at + 1, "a comma, not a semicolon, stands between two values");
        if (utf8[at] == '#') return Comment(at);
        if (utf8[at] is (byte)':' or (byte)'=') return new(at, at + 1, $"'{(char)utf8[at]}' cannot follow a value; a comma or a bracket can");

        var line = tree.Text.LineOf(valueEnd - 1);
        if (line != tree.Text.LineOf(at)) return new(at, TokenEnd(at), $"a comma is missing after line {line}");
        var end = utf8[at] == '"' && Text(at, out var textEnd) is null ? textEnd : TokenEnd(at);
        return new(at, end, $"a comma is missing before {tree.Text.Quote(at, end)}");
    }

    private JsonMistake? Key(int at)
    {
        if (Lookalike(at) is { } lookalike) return lookalike;
        switch ((char)utf8[at])
        {
            case '"':
                var text = Text(at, out var end);
                if (text is not null) return text;
                var colon = SkipBlanks(end);
                if (colon == utf8.Length) return CutOff();
                if (utf8[colon] == ':') return null;
                if (utf8[colon] == '/') return Slash(colon);
                var hint = utf8[colon] == '=' ? ", not '='," : "";
                return new(colon, TokenEnd(colon), $"a colon{hint} must follow the key {tree.Text.Quote(at, end)}");
            case '\'':
                return new(at, TokenEnd(at), "keys stand in double quotes, not in single ones");
            case ',':
                return new(at, at + 1, "there is one comma too many");
            case ':':
                return new(at, at + 1, "a key is missing before the colon");
            case '}' or ']':
                return WrongBracket(at);
            case '{' when last == JsonTokenType.EndObject && tree.KeyOfLastClosed is { } key:
                var name = tree.Text.Quote(tree[key].Start, tree[key].End);
                return new(at, at + 1, $"a second object follows the one of {name}; several stand in brackets: {name}: [ {{ ... }}, {{ ... }} ]");
            case '{' or '[':
                return new(at, at + 1, "a key in double quotes must come first: \"key\": value");
            case '#':
                return Comment(at);
            case '/':
                return Slash(at);
            case >= '0' and <= '9' when last == JsonTokenType.Number:
                return new(at, TokenEnd(at), $"a key is expected here; is this a decimal comma? Write {PointForComma(at)}");
            default:
                return new(at, TokenEnd(at), $"keys stand in double quotes: \"{Word(at)}\"");
        }
    }

    private JsonMistake? Value(int at)
    {
        if (Lookalike(at) is { } lookalike) return lookalike;
        switch ((char)utf8[at])
        {
            case '"':
                return Text(at, out var end) ?? (end == utf8.Length ? CutOff() : null);
            case '{' or '[' when open.Length == JsonTree.MaxDepth:
                return new(at, at + 1, $"arrays and objects are nested deeper than {JsonTree.MaxDepth}");
            case '\'':
                return new(at, TokenEnd(at), "texts stand in double quotes, not in single ones");
            case ',':
                return new(at, at + 1, last == JsonTokenType.PropertyName ? "a value is missing after the colon" : "there is one comma too many");
            case '}' or ']':
                return last == JsonTokenType.PropertyName ? new(at, at + 1, "a value is missing after the colon") : WrongBracket(at);
            case ':' or '=':
                return new(at, at + 1, $"a value is expected here, not '{(char)utf8[at]}'");
            case '#':
                return Comment(at);
            case '/':
                return Slash(at);
            case '.' or '+' or '-' or (>= '0' and <= '9'):
                return Number(at);
            default:
                return Literal(at);
        }
    }

    private JsonMistake? Number(int at)
    {
        var end = TokenEnd(at);
        var word = Word(at);
        var digits = at;
        if (utf8[at] == '+') return new(at, end, $"a number has no plus sign: write {word[1..]}");
        if (utf8[at] == '-') digits++;
        if (digits < end && utf8[digits] == '.') return new(at, end, $"a number needs a digit before the point: {word.Replace(".", "0.")}");
        if (digits == end || !IsDigit(digits))
            return word is "-Infinity" or "-NaN" ? NotFinite(at) : new(at, Math.Max(end, at + 1), "a digit must follow the minus sign");
        if (utf8[digits] == '0' && IsDigit(digits + 1)) return new(at, end, $"a number does not begin with 0: write {WithoutZeros(word)}");
        if (utf8[digits] == '0' && digits + 1 < end && (utf8[digits + 1] | 0x20) == 'x') return new(at, end, $"numbers are decimal; {word} is not");

        var i = digits;
        while (IsDigit(i)) i++;
        if (i < end && utf8[i] == '.')
        {
            if (!IsDigit(++i) && i < utf8.Length) return new(at, end, "a digit must follow the point of a number, or leave the point out");
            while (IsDigit(i)) i++;
        }
        if (i < end && (utf8[i] | 0x20) == 'e')
        {
            i++;
            if (i < end && utf8[i] is (byte)'+' or (byte)'-') i++;
            if (!IsDigit(i) && i < utf8.Length) return new(at, end, "a digit must follow the e of a number: 1e-6");
            while (IsDigit(i)) i++;
        }
        if (i == utf8.Length) return CutOff();
        if (i == end) return AfterValue(SkipBlanks(end), end);
        return new(at, end, $"{word} is not a number; a number ends before '{Character(i)}'");
    }

    private JsonMistake? Literal(int at)
    {
        var word = Word(at);
        var end = TokenEnd(at);
        foreach (var literal in (ReadOnlySpan<string>)["true", "false", "null"])
        {
            if (literal == word) return null;
            if (literal.StartsWith(word, StringComparison.Ordinal) && end == utf8.Length) return CutOff();
            if (literal.Equals(word, StringComparison.OrdinalIgnoreCase)) return new(at, end, $"{word} is written {literal} in JSON");
        }
        if (word is "NaN" or "Infinity" or "nan" or "inf" or "INF") return NotFinite(at);
        return char.IsLetter(word[0]) || word[0] == '_'
            ? new(at, end, $"{word} is not a value; texts stand in double quotes: \"{word}\"")
            : new(at, end, $"a value is expected here, not '{Character(at)}'");
    }

    /// <summary>Characters that come with text copied from a page or a word processor.</summary>
    private JsonMistake? Lookalike(int at)
    {
        Rune.DecodeFromUtf8(utf8[at..], out var rune, out var length);
        if (rune.Value is '“' or '”' or '„' or '«' or '»' or '‘' or '’')
            return new(at, TokenEnd(at), $"texts and keys stand in straight double quotes \", not in {rune}");
        if (rune.Value is 0xFEFF or 0x200B || (!rune.IsAscii && Rune.IsWhiteSpace(rune)))
            return new(at, at + length, $"the character U+{rune.Value:X4} looks like a space or like nothing, but JSON wants a plain space");
        return null;
    }

    private JsonMistake NotFinite(int at) => new(at, TokenEnd(at), $"{Word(at)} is not allowed; a number must be finite");

    /// <summary>What is wrong with a text, or null and its end.</summary>
    private JsonMistake? Text(int at, out int end)
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
            if (c != '\\') continue;
            if (end + 1 == utf8.Length) return CutOff();
            if (utf8[end + 1] == 'u')
            {
                for (var i = end + 2; i < end + 6; i++)
                {
                    if (i == utf8.Length) return CutOff();
                    if (!char.IsAsciiHexDigit((char)utf8[i])) return new(end, i, "four hexadecimal digits must follow \\u");
                }
            }
            else if (!"\"\\/bfnrt"u8.Contains(utf8[end + 1]))
            {
                return new(end, end + 2, "a backslash in a text is written twice: \\\\ (a path may have / instead)");
            }
            end++;
        }
        return CutOff($"the text that begins in line {tree.Text.LineOf(at)} is never closed");
    }

    private JsonMistake CutOff(string? reason = null)
    {
        var end = utf8.Length;
        if (reason is null && open.Length > 0)
        {
            var bracket = tree[open[^1]];
            reason = $"the {Bracket(bracket)} of line {tree.Text.LineOf(bracket.Start)} is never closed";
        }
        return new(end, end, $"the file ends too early: {reason ?? "a value is missing"}");
    }

    private JsonMistake WrongBracket(int at)
    {
        var found = (char)utf8[at];
        if (open.Length == 0) return new(at, at + 1, $"there is a {found} but nothing that it closes");
        var bracket = tree[open[^1]];
        var line = tree.Text.LineOf(bracket.Start);
        var isPair = found == (bracket.Kind == JsonTokenType.StartObject ? '}' : ']');
        return new(at, at + 1, isPair
            ? "there is one comma too many"
            : $"the {Bracket(bracket)} of line {line} is not closed before this {found}");
    }

    private static JsonMistake Comment(int at) => new(at, at + 1, "a comment starts with //, not with #");

    private JsonMistake Fraction(int at)
    {
        var number = tree.Last;
        var end = TokenEnd(at + 1);
        return new(number.Start, end, $"{tree.Text.Quote(number.Start, end)} is not a number; JSON knows no fractions: write 0.5 for 1/2");
    }

    private JsonMistake Slash(int at) => IsComment(at)
        ? new(at, at + 2, "this comment is never closed; */ is missing")
        : new(at, at + 1, "a comment starts with // or stands between /* and */");

    /// <summary>What the JSON reader says, without its own count of lines.</summary>
    private JsonMistake Fallback(JsonException refusal)
    {
        var at = SkipBlanks(lastEnd);
        var count = refusal.Message.IndexOf(" LineNumber:", StringComparison.Ordinal);
        return new(at, at, "this is not JSON: " + (count > 0 ? refusal.Message[..count] : refusal.Message));
    }

    private static string Bracket(JsonTree.Node node) => node.Kind == JsonTokenType.StartObject ? "{" : "[";

    /// <summary>The place of the next byte that is neither blank nor comment; of a comment that is never closed its start.</summary>
    private int SkipBlanks(int at)
    {
        while (at < utf8.Length)
        {
            if (utf8[at] is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n')
            {
                at++;
            }
            else if (utf8[at..].StartsWith("//"u8))
            {
                at = LineEnd(at);
            }
            else if (IsComment(at))
            {
                var length = utf8[(at + 2)..].IndexOf("*/"u8);
                if (length < 0) return at;
                at += length + 4;
            }
            else
            {
                break;
            }
        }
        return at;
    }

    private bool IsComment(int at) => utf8[at..].StartsWith("/*"u8);

    private int LineEnd(int at) => utf8[at..].IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? at + length : utf8.Length;

    private bool IsDigit(int at) => at < utf8.Length && utf8[at] is >= (byte)'0' and <= (byte)'9';

    /// <summary>The end of what looks like one word or number, at least one byte further.</summary>
    private int TokenEnd(int at)
    {
        var length = utf8[at..].IndexOfAny(" \t\r\n,:;[]{}/=\""u8);
        return length switch { < 0 => utf8.Length, 0 => at + 1, _ => at + length };
    }

    private string Word(int at) => tree.Text.Quote(at, TokenEnd(at));

    private string Character(int at)
    {
        Rune.DecodeFromUtf8(utf8[at..], out _, out var length);
        return tree.Text.Quote(at, at + length);
    }

    private static string WithoutZeros(string word)
    {
        var sign = word[0] == '-' ? "-" : "";
        var rest = word.AsSpan(sign.Length).TrimStart('0');
        return sign + (rest.IsEmpty || !char.IsAsciiDigit(rest[0]) ? "0" : "") + rest.ToString();
    }

    private string PointForComma(int at)
    {
        var whole = tree.Last;
        return $"{tree.Text.Quote(whole.Start, whole.End)}.{Word(at)}";
    }
}
