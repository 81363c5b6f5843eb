namespace RayCaster;

/// <summary>
/// Reads a JSON text (RFC 8259) from left to right into a tree. Comments and trailing commas are allowed. Our own, since the platform's reader takes
/// ten milliseconds for its first token, and as long again to say in our words what is wrong.
/// </summary>
internal ref struct JsonScanner(JsonTree tree)
{
    private readonly ReadOnlySpan<byte> utf8 = tree.Text.Utf8;
    private readonly int[] open = new int[JsonTree.MaxDepth]; // the arrays and objects that are not closed yet
    private int depth;
    private JsonKind last;
    private int lastEnd; // the place after the last token; after a key that of its colon

    /// <summary>Why the text breaks off, after <see cref="Scan"/> has said so.</summary>
    public readonly JsonMistake Mistake => new JsonExpectation(tree, open.AsSpan(0, depth), last, lastEnd).Explain();

    /// <summary>Reads it all.</summary>
    /// <returns>Whether it is JSON; if not, the tree holds what stands before the mistake.</returns>
    public bool Scan()
    {
        var afterValue = false; // where a comma or the closing bracket comes next
        while (true)
        {
            var at = SkipBlanks(lastEnd);
            if (afterValue && depth > 0 && at < utf8.Length && utf8[at] == ',')
            {
                at = SkipBlanks(at + 1);
                afterValue = false;
            }
            if (at == utf8.Length) return depth == 0 && afterValue;

            var opening = depth == 0 ? JsonKind.None : tree[open[depth - 1]].Kind;
            var c = utf8[at];
            if (c is (byte)'}' or (byte)']')
            {
                if (opening != (c == '}' ? JsonKind.Object : JsonKind.Array) || last == JsonKind.Key) return false;
                lastEnd = at + 1;
                tree.Close(open[--depth], lastEnd);
                (last, afterValue) = (JsonKind.End, true);
                continue;
            }
            if (afterValue) return false;

            if (opening == JsonKind.Object && last != JsonKind.Key)
            {
                var keyEnd = c == '"' ? EndOfText(at) : -1;
                var colon = keyEnd < 0 ? utf8.Length : SkipBlanks(keyEnd);
                if (colon == utf8.Length || utf8[colon] != ':') return false;
                tree.Add(JsonKind.Key, at, keyEnd);
                (last, lastEnd) = (JsonKind.Key, colon + 1);
                continue;
            }

            if (c is (byte)'{' or (byte)'[')
            {
                if (depth == JsonTree.MaxDepth) return false;
                (last, lastEnd) = (c == '{' ? JsonKind.Object : JsonKind.Array, at + 1);
                open[depth++] = tree.Add(last, at, lastEnd);
                continue;
            }

            var kind = c switch
            {
                (byte)'"' => JsonKind.Text,
                (byte)'t' or (byte)'f' or (byte)'n' => JsonKind.Literal,
                _ => JsonKind.Number,
            };
            var end = kind == JsonKind.Text ? EndOfText(at) : kind == JsonKind.Literal ? EndOfLiteral(at) : EndOfNumber(at);
            if (end < 0) return false;
            tree.Add(kind, at, end);
            (last, lastEnd, afterValue) = (kind, end, true);
        }
    }

    /// <summary>The place of the next byte that is neither blank nor in a comment; of a comment that is never closed its start.</summary>
    private readonly int SkipBlanks(int at)
    {
        for (; at < utf8.Length; at++)
        {
            if (utf8[at] is (byte)' ' or (byte)'\t' or (byte)'\r' or (byte)'\n') continue;
            if (utf8[at] != '/') return at;
            var end = EndOfComment(at);
            if (end < 0) return at;
            at = end - 1;
        }
        return at;
    }

    /// <summary>The place after a comment; −1 if it is none, or never closed.</summary>
    private readonly int EndOfComment(int at)
    {
        var rest = utf8[(at + 1)..];
        if (rest.IsEmpty || rest[0] is not ((byte)'/' or (byte)'*')) return -1;
        if (rest[0] == '*') return rest[1..].IndexOf("*/"u8) is >= 0 and var inside ? at + inside + 4 : -1;
        return rest.IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? at + 1 + length : utf8.Length;
    }

    /// <summary>The place after the quote that closes a text; −1 where the text is not right.</summary>
    private readonly int EndOfText(int at)
    {
        while (++at < utf8.Length)
        {
            var c = utf8[at];
            if (c == '"') return at + 1;
            if (c < 0x20) return -1;
            if (c != '\\') continue;
            if (++at == utf8.Length) return -1;
            if (utf8[at] is (byte)'"' or (byte)'\\' or (byte)'/' or (byte)'b' or (byte)'f' or (byte)'n' or (byte)'r' or (byte)'t') continue;
            if (utf8[at] != 'u') return -1;
            for (var digit = 0; digit < 4; digit++)
                if (++at == utf8.Length || !char.IsAsciiHexDigit((char)utf8[at]))
                    return -1;
        }
        return -1;
    }

    private readonly int EndOfLiteral(int at)
    {
        var rest = utf8[at..];
        return rest.StartsWith("true"u8) || rest.StartsWith("null"u8) ? at + 4 : rest.StartsWith("false"u8) ? at + 5 : -1;
    }

    /// <summary>The place after a number; −1 where it is not right, or is followed by what cannot follow a number.</summary>
    private readonly int EndOfNumber(int at)
    {
        if (utf8[at] == '-') at++;
        var digits = at;
        at = SkipDigits(at);
        if (at == digits || (utf8[digits] == '0' && at > digits + 1)) return -1;
        if (at < utf8.Length && utf8[at] == '.')
        {
            digits = at + 1;
            at = SkipDigits(digits);
            if (at == digits) return -1;
        }
        if (at < utf8.Length && utf8[at] is (byte)'e' or (byte)'E')
        {
            digits = at + 1;
            if (digits < utf8.Length && utf8[digits] is (byte)'+' or (byte)'-') digits++;
            at = SkipDigits(digits);
            if (at == digits) return -1;
        }
        return at == utf8.Length || utf8[at] is (byte)',' or (byte)'}' or (byte)']' or (byte)' ' or (byte)'\n' or (byte)'\r' or (byte)'\t' or (byte)'/'
            ? at
            : -1;
    }

    private readonly int SkipDigits(int at)
    {
        while (at < utf8.Length && utf8[at] is >= (byte)'0' and <= (byte)'9') at++;
        return at;
    }
}
