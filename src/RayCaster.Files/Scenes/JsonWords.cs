namespace RayCaster.Files;

/// <summary>Finds blanks and words in a text that is not JSON.</summary>
internal readonly ref struct JsonWords(SourceText text)
{
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
}
