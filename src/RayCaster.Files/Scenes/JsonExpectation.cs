namespace RayCaster.Files;

/// <summary>Why a text is not JSON.</summary>
/// <param name="End">The place after the last byte to underline.</param>
internal readonly record struct JsonMistake(int Start, int End, string Message);

/// <summary>
/// Says why a text is not JSON, after <see cref="Utf8JsonReader"/> has refused it: compares what follows the last good token with what JSON
/// allows there.
/// </summary>
/// <param name="lastEnd">The place after the last good token; after a key the place after its colon.</param>
/// <param name="takesText">Whether the value of a key, or its elements, may be texts.</param>
internal readonly ref struct JsonExpectation(JsonTree tree, ReadOnlySpan<int> open, JsonTokenType last, int lastEnd, Predicate<string> takesText)
{
    private const int LongestWord = 240; // bytes of a word in which a character that looks like another is sought

    private readonly ReadOnlySpan<byte> utf8 = tree.Text.Utf8;
    private readonly ReadOnlySpan<int> open = open;

    public JsonMistake Explain()
    {
        var at = SkipBlanks(lastEnd);
        if (at == utf8.Length && last == JsonTokenType.None) return new(at, at, "the file is empty; it must contain an object in braces { }");
        var isComma = at < utf8.Length && utf8[at] == ',' && open.Length > 0
            && last is not (JsonTokenType.PropertyName or JsonTokenType.StartArray or JsonTokenType.StartObject);
        if (isComma) at = SkipBlanks(at + 1);
        if (at == utf8.Length) return CutOff();
        var isObject = open.Length > 0 && tree[open[^1]].Kind == JsonTokenType.StartObject;
        if (last == JsonTokenType.StartObject || (isComma && isObject)) return Key(at);
        return isComma || last is JsonTokenType.None or JsonTokenType.PropertyName or JsonTokenType.StartArray ? Value(at)
            : AfterValue(at, lastEnd);
    }

    /// <summary>What stands where a comma or a closing bracket should.</summary>
    private JsonMistake AfterValue(int at, int valueEnd)
    {
        if (at == utf8.Length) return CutOff();
        if (last is JsonTokenType.True or JsonTokenType.False or JsonTokenType.Null && at == valueEnd && char.IsLetter((char)utf8[at]))
            return Bare(tree.Last.Start); // nullptr
        var c = (char)utf8[at];
        if ((open.Length == 0 && c is '}' or ']' or '#' ? null : Misplaced(at)) is { } mistake) return mistake;
        if (open.Length == 0) return new(at, LineEnd(at), "the scene has ended before this; a file holds one object");
        if (c == ';') return new(at, at + 1, "a comma, not a semicolon, stands between two values");
        if (c == ':' && last == JsonTokenType.String && KeyInArray(tree.Last.Start, valueEnd) is { } key) return key;
        if (c is ':' or '=') return new(at, at + 1, $"'{c}' cannot follow a value; a comma or a bracket can");
        var end = c == '"' && Text(at, out var textEnd) is null ? textEnd : End(at);
        if (c == '"' && KeyInArray(at, end) is { } inArray) return inArray;
        var line = tree.Text.LineOf(valueEnd - 1);
        return line == tree.Text.LineOf(at) ? new(at, end, $"a comma is missing before {tree.Text.Quote(at, end)}")
            : new(at, End(at), $"a comma is missing after line {line}");
    }

    private JsonMistake Key(int at)
    {
        if (Misplaced(at) is { } mistake) return mistake;
        switch ((char)utf8[at])
        {
            case '"':
                if (Text(at, out var end) is { } unfinished) return unfinished;
                var colon = SkipBlanks(end);
                if (colon == utf8.Length) return CutOff();
                var key = tree.Text.Quote(at, end);
                if (utf8[colon] == ':' && SkipBlanks(colon + 1) == utf8.Length) return CutOff();
                if (utf8[colon] == ':') return new(end, colon, $"no comment may stand between the key {key} and its colon");
                return Misplaced(colon) ?? new(colon, End(colon), $"a colon{(utf8[colon] == '=' ? ", not '='," : "")} must follow the key {key}");
            case '\'':
                return new(at, End(at), "a key is written in double quotes, not in single ones");
            case ',':
                return new(at, at + 1, "there is one comma too many");
            case ':':
                return new(at, at + 1, "a key is missing before the colon");
            case '{' when last == JsonTokenType.EndObject && tree.KeyOfLastClosed is { } before:
                var name = tree.Text.Quote(tree[before].Start, tree[before].End);
                return new(at, at + 1, $"a second object follows the one of {name}; write several in brackets: {name}: [ {{ ... }}, {{ ... }} ]");
            case >= '0' and <= '9' when last == JsonTokenType.Number:
                var whole = tree.Text.Quote(tree.Last.Start, tree.Last.End);
                return new(at, End(at), "a key is expected here" + NumberSpelling.Hint($"{whole},{Word(at)}"));
            default:
                return new(at, End(at), char.IsLetter(Word(at)[0]) || utf8[at] == '_' ? $"a key is written in double quotes: \"{Word(at)}\""
                    : "a key in double quotes must come first: \"key\": value");
        }
    }

    private JsonMistake Value(int at)
    {
        var c = (char)utf8[at];
        if (c is ',' or '}' or ']' && last == JsonTokenType.PropertyName) return new(at, at + 1, "a value is missing after the colon");
        var isQuote = c is '\'' or '`' || Lookalike.ToAscii(Word(at))[0] == '"';
        if (isQuote && c != '"' && !MayBeText()) return new(at, End(at), $"{Word(at)} is not a number; numbers have no quotes");
        if (Misplaced(at) is { } mistake) return mistake;
        return c switch
        {
            ',' => new(at, at + 1, "there is one comma too many"),
            ':' or '=' => new(at, at + 1, $"a value is expected here, not '{c}'"),
            '{' or '[' => new(at, at + 1, $"arrays and objects are nested deeper than {JsonTree.MaxDepth}"),
            '"' => Text(at, out _) ?? CutOff(),
            '\'' or '`' => new(at, End(at), "a text is written in double quotes, not in single ones"),
            _ => Bare(at),
        };
    }

    /// <summary>A word without quotes in place of a value.</summary>
    private JsonMistake Bare(int at)
    {
        var end = End(at);
        var word = Word(at);
        var whole = Encoding.UTF8.GetString(utf8[at..Math.Min(end, at + LongestWord)]);
        string[] known = ["true", "false", "null"];
        if (end == utf8.Length && (known.Any(literal => literal.StartsWith(word, StringComparison.Ordinal)) || JsonForeign.IsBegunNumber(word)))
            return CutOff();
        if (NumberSpelling.Correct(word) is { } number)
            return number == word ? AfterValue(SkipBlanks(end), end) : new(at, end, $"{word} is not a number in JSON: write {number}");
        if (Lookalike.FindIn(whole) is var (index, message))
        {
            var from = at + Encoding.UTF8.GetByteCount(whole.AsSpan(0, index));
            return new(from, from + Rune.GetRuneAt(whole, index).Utf8SequenceLength, message);
        }
        if (known.Contains(word)) return AfterValue(SkipBlanks(end), end);
        return new(at, end, JsonForeign.Explain(word) ?? (MayBeText() ? $"{word} is not a value; a text is written in double quotes: \"{word}\""
            : $"{word} is no value that may stand here; numbers are written like 1, -0.5 or 1e-6"));
    }

    private JsonMistake CutOff()
    {
        var reason = open.Length > 0 ? $"the {Bracket(out var line)} of line {line} is never closed" : "a value is missing";
        return new(utf8.Length, utf8.Length, $"the file ends too early: {reason}");
    }

    private JsonMistake WrongBracket(int at)
    {
        var found = (char)utf8[at];
        if (open.Length == 0) return new(at, at + 1, $"there is a {found} but nothing that it closes");
        var bracket = Bracket(out var line);
        var (pair, justClosed) = found == ']' ? ('[', JsonTokenType.EndArray) : ('{', JsonTokenType.EndObject);
        var isOpen = false;
        foreach (var node in open) isOpen |= utf8[tree[node].Start] == pair;
        return new(at, at + 1,
            bracket == pair ? "there is one comma too many"
            : !isOpen ? $"there is one {found} too many: the {bracket} of line {line} is open here, and no {pair}"
            : last == justClosed ? $"there is one {found} too many, or the {bracket} of line {line} is not closed before it"
            : $"the {bracket} of line {line} is not closed before this {found}");
    }

    /// <summary>A key behind the elements of an array, whose bracket is missing; null for anything else.</summary>
    private JsonMistake? KeyInArray(int at, int end)
    {
        var colon = SkipBlanks(end);
        var isKey = utf8[at] == '"' && colon < utf8.Length && utf8[colon] == ':';
        if (!isKey || Bracket(out var line) != '[' || at == SkipBlanks(tree[open[^1]].Start + 1)) return null;
        return new(at, end, $"the [ of line {line} is not closed before the key {tree.Text.Quote(at, end)}");
    }

    private char Bracket(out int line)
    {
        var start = tree[open[^1]].Start;
        line = tree.Text.LineOf(start);
        return (char)utf8[start];
    }

    /// <summary>Whether a text may stand where the reader stopped: as the value of a key that takes one, or in its array.</summary>
    private bool MayBeText()
    {
        var key = tree.Count - 1;
        for (var i = open.Length - 1; last != JsonTokenType.PropertyName && i >= 0 && utf8[tree[open[i]].Start] == '['; i--) key = open[i] - 1;
        return key >= 0 && tree[key].Kind == JsonTokenType.PropertyName && takesText(new JsonValue(tree, key).Text);
    }

    /// <summary>What is a mistake wherever it stands; null for anything else.</summary>
    private JsonMistake? Misplaced(int at)
    {
        if (JsonForeign.IsMergeMarker(utf8[at..]))
            return new(at, LineEnd(at), $"this is {JsonForeign.Merge}: keep one version, and remove the lines of <<<<<<<, ======= and >>>>>>>");
        Rune.DecodeFromUtf8(utf8[at..], out var c, out var length);
        return c.Value switch
        {
            '}' or ']' => WrongBracket(at),
            '#' => new(at, at + 1, "a comment starts with //, not with #"),
            '/' when utf8[at..].StartsWith("/*"u8) => new(at, at + 2, "this comment is never closed; */ is missing"),
            '/' => new(at, at + 1, "a comment starts with // or stands between /* and */"),
            _ => Lookalike.Describe(c) is { } message ? new(at, at + length, message) : null,
        };
    }

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
            if (c != '\\' || ++end == utf8.Length) continue;
            var digits = utf8[(end + 1)..Math.Min(end + 5, utf8.Length)];
            if (!"\"\\/bfnrtu"u8.Contains(utf8[end]))
                return new(end - 1, end + 1, "a backslash in a text is written twice: \\\\ (a path may have / instead)");
            if (utf8[end] == 'u' && digits.IndexOfAnyExcept("0123456789abcdefABCDEF"u8) is >= 0 and var wrong)
                return new(end - 1, end + 1 + wrong, "four hexadecimal digits must follow \\u (a backslash is written twice: \\\\)");
        }
        end = utf8.Length;
        return new(end, end, $"the file ends too early: the text that begins in line {tree.Text.LineOf(at)} is never closed");
    }

    /// <summary>The next place that holds neither a blank nor a comment. A comment that is not closed is not skipped.</summary>
    private int SkipBlanks(int at)
    {
        for (var length = 1; length > 0 && at < utf8.Length; at += length)
            length = utf8[at] is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n' ? 1
                : utf8[at..].StartsWith("//"u8) ? LineEnd(at) - at
                : utf8[at..].StartsWith("/*"u8) && utf8[(at + 2)..].IndexOf("*/"u8) is >= 0 and var inner ? inner + 4 : 0;
        return at;
    }

    private int LineEnd(int at) => utf8[at..].IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? at + length : utf8.Length;

    /// <summary>The end of what looks like one word or number, at least one byte further.</summary>
    private int End(int at) => utf8[at..].IndexOfAny(" \t\r\n,:;[]{}/=\""u8) switch
    {
        < 0 => utf8.Length,
        0 => at + 1,
        var length => at + length,
    };

    private string Word(int at) => tree.Text.Quote(at, End(at));
}
