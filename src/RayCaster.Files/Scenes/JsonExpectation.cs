namespace RayCaster.Files;

/// <summary>Why a text is not JSON.</summary>
/// <param name="End">The place after the last byte to underline.</param>
internal readonly record struct JsonMistake(int Start, int End, string Message);

/// <summary>
/// Says why a text is not JSON, after <see cref="Utf8JsonReader"/> has refused it: compares what follows the last good token with what JSON
/// allows there.
/// </summary>
/// <param name="lastEnd">The place after the last good token; after a key the place after its colon.</param>
internal readonly ref struct JsonExpectation(JsonTree tree, ReadOnlySpan<int> open, JsonTokenType last, int lastEnd)
{
    private readonly ReadOnlySpan<byte> utf8 = tree.Text.Utf8;
    private readonly ReadOnlySpan<int> open = open;
    private readonly JsonWords words = new(tree.Text);

    /// <param name="refusal">The JSON reader's own message, for a mistake that is not known here.</param>
    public JsonMistake Explain(JsonException refusal)
    {
        var at = words.SkipBlanks(lastEnd);
        if (at == utf8.Length)
            return last == JsonTokenType.None ? new(at, at, "the file is empty; it must contain an object in braces { }") : CutOff();

        return last switch
        {
            JsonTokenType.StartObject => Key(at),
            JsonTokenType.None or JsonTokenType.PropertyName or JsonTokenType.StartArray => Value(at),
            _ => AfterValue(at, lastEnd),
        } ?? Unknown(at, refusal);
    }

    private JsonMistake? AfterValue(int at, int valueEnd)
    {
        var c = (char)utf8[at];
        if (c == '/' && last == JsonTokenType.Number && at == valueEnd && words.IsDigit(at + 1)) return Fraction(at);
        if (c != '/' && open.Length == 0)
            return words.Lookalike(at) ?? new(at, words.LineEnd(at), "the scene has ended before this; a file holds one object");
        if (Misplaced(at) is { } mistake) return mistake;
        switch (c)
        {
            case ',':
                var next = words.SkipBlanks(at + 1);
                if (next == utf8.Length) return CutOff();
                return tree[open[^1]].Kind == JsonTokenType.StartObject ? Key(next) : Value(next);
            case ';':
                return new(at, at + 1, "a comma, not a semicolon, stands between two values");
            case ':' when last == JsonTokenType.String && KeyInArray(tree.Last.Start, valueEnd) is { } key:
                return key;
            case ':' or '=':
                return new(at, at + 1, $"'{c}' cannot follow a value; a comma or a bracket can");
        }
        if (c == '"' && words.Text(at, out var keyEnd) is null && KeyInArray(at, keyEnd) is { } inArray) return inArray;
        var line = tree.Text.LineOf(valueEnd - 1);
        if (line != tree.Text.LineOf(at)) return new(at, words.End(at), $"a comma is missing after line {line}");
        var end = c == '"' && words.Text(at, out var textEnd) is null ? textEnd : words.End(at);
        return new(at, end, $"a comma is missing before {tree.Text.Quote(at, end)}");
    }

    private JsonMistake? Key(int at)
    {
        if (Misplaced(at) is { } mistake) return mistake;
        switch ((char)utf8[at])
        {
            case '"':
                if (words.Text(at, out var end) is { } unfinished) return unfinished;
                var colon = words.SkipBlanks(end);
                if (colon == utf8.Length) return CutOff();
                if (utf8[colon] == ':' && !utf8[end..colon].Contains((byte)'/')) return null;
                if (utf8[colon] == ':') return new(end, colon, $"no comment may stand between the key {tree.Text.Quote(at, end)} and its colon");
                if (utf8[colon] == '/') return Misplaced(colon);
                var hint = utf8[colon] == '=' ? ", not '='," : "";
                return new(colon, words.End(colon), $"a colon{hint} must follow the key {tree.Text.Quote(at, end)}");
            case '\'':
                return new(at, words.End(at), "a key is written in double quotes, not in single ones");
            case ',':
                return new(at, at + 1, "there is one comma too many");
            case ':':
                return new(at, at + 1, "a key is missing before the colon");
            case '{' when last == JsonTokenType.EndObject && tree.KeyOfLastClosed is { } key:
                var name = tree.Text.Quote(tree[key].Start, tree[key].End);
                return new(at, at + 1, $"a second object follows the one of {name}; write several in brackets: {name}: [ {{ ... }}, {{ ... }} ]");
            case '{' or '[':
                return new(at, at + 1, "a key in double quotes must come first: \"key\": value");
            case >= '0' and <= '9' when last == JsonTokenType.Number:
                var whole = tree.Text.Quote(tree.Last.Start, tree.Last.End);
                return new(at, words.End(at), $"a key is expected here; is this a decimal comma? Write {whole}.{words.Word(at)}");
            default:
                return new(at, words.End(at), $"a key is written in double quotes: \"{words.Word(at)}\"");
        }
    }

    private JsonMistake? Value(int at)
    {
        var c = (char)utf8[at];
        var end = words.End(at);
        if (c is ',' or '}' or ']' && last == JsonTokenType.PropertyName) return new(at, at + 1, "a value is missing after the colon");
        if (Misplaced(at) is { } mistake) return mistake;
        switch (c)
        {
            case '"':
                return words.Text(at, out end) ?? (end == utf8.Length ? CutOff() : null);
            case '{' or '[' when open.Length == JsonTree.MaxDepth:
                return new(at, at + 1, $"arrays and objects are nested deeper than {JsonTree.MaxDepth}");
            case '\'':
                return new(at, end, "a text is written in double quotes, not in single ones");
            case ',':
                return new(at, at + 1, "there is one comma too many");
            case ':' or '=':
                return new(at, at + 1, $"a value is expected here, not '{c}'");
            case '.' or '+' or '-' or (>= '0' and <= '9'):
                return words.Number(at) ?? (end == utf8.Length ? CutOff() : AfterValue(words.SkipBlanks(end), end));
            default:
                return words.Literal(at) ?? (end == utf8.Length ? CutOff() : null);
        }
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
        return new(at, at + 1,
            bracket == pair ? "there is one comma too many"
            : !IsOpen(pair) ? $"there is one {found} too many: the {bracket} of line {line} is open here, and no {pair}"
            : last == justClosed ? $"there is one {found} too many, or the {bracket} of line {line} is not closed before it"
            : $"the {bracket} of line {line} is not closed before this {found}");
    }

    private bool IsOpen(char bracket)
    {
        foreach (var node in open)
            if (utf8[tree[node].Start] == bracket) return true;
        return false;
    }

    /// <summary>A key behind the elements of an array, whose bracket is missing; null for anything else.</summary>
    private JsonMistake? KeyInArray(int at, int end)
    {
        var colon = words.SkipBlanks(end);
        var isKey = utf8[at] == '"' && colon < utf8.Length && utf8[colon] == ':';
        if (!isKey || Bracket(out var line) != '[' || at == words.SkipBlanks(tree[open[^1]].Start + 1)) return null;
        return new(at, end, $"the [ of line {line} is not closed before the key {tree.Text.Quote(at, end)}");
    }

    /// <summary>The innermost bracket that is open.</summary>
    private char Bracket(out int line)
    {
        var start = tree[open[^1]].Start;
        line = tree.Text.LineOf(start);
        return (char)utf8[start];
    }

    /// <summary>What is a mistake wherever it stands; null for anything else.</summary>
    private JsonMistake? Misplaced(int at) => (char)utf8[at] switch
    {
        '}' or ']' => WrongBracket(at),
        '#' => new(at, at + 1, "a comment starts with //, not with #"),
        '/' when utf8[at..].StartsWith("/*"u8) => new(at, at + 2, "this comment is never closed; */ is missing"),
        '/' => new(at, at + 1, "a comment starts with // or stands between /* and */"),
        _ => words.Lookalike(at),
    };

    private JsonMistake Fraction(int at)
    {
        var start = tree.Last.Start;
        var end = words.End(at + 1);
        return new(start, end, $"{tree.Text.Quote(start, end)} is not a number; JSON has no fractions: write 0.5 for 1/2");
    }

    /// <summary>The JSON reader's message without its own count of lines.</summary>
    private static JsonMistake Unknown(int at, JsonException refusal)
    {
        var count = refusal.Message.IndexOf(" LineNumber:", StringComparison.Ordinal);
        return new(at, at, "this is not JSON: " + (count > 0 ? refusal.Message[..count] : refusal.Message));
    }
}
