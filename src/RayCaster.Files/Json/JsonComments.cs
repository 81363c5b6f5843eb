namespace RayCaster.Files;

/// <summary>Comments in a JSON text: from // to the end of the line, and from /* to */.</summary>
internal static class JsonComments
{
    /// <summary>The place after the comment that begins at a place. The place itself where no comment begins, or where one is not closed.</summary>
    public static int EndOf(ReadOnlySpan<byte> utf8, int at)
    {
        var text = utf8[at..];
        if (text.StartsWith("//"u8)) return at + (text.IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? length : text.Length);
        return text.StartsWith("/*"u8) && text[2..].IndexOf("*/"u8) is >= 0 and var inner ? at + inner + 4 : at;
    }

    /// <summary>The text with spaces in place of comments. <see cref="System.Text.Json.Utf8JsonReader"/> could skip comments itself, but not
    /// those between a key and its colon.</summary>
    public static ReadOnlySpan<byte> Blanked(ReadOnlySpan<byte> utf8)
    {
        byte[]? copy = null;
        if (utf8.IndexOf((byte)'/') < 0) return utf8;
        for (var i = 0; utf8[i..].IndexOfAny((byte)'"', (byte)'/') is >= 0 and var way;)
        {
            i += way;
            if (utf8[i] == '"')
            {
                i = EndOfText(utf8, i);
                continue;
            }
            var end = EndOf(utf8, i);
            if (end == i) break; // the JSON reader refuses this slash; to look for more comments could take quadratic time
            copy ??= utf8.ToArray();
            for (; i < end; i++) copy[i] = (byte)' '; // Span.Fill is a long method to compile at start-up
        }
        return copy ?? utf8;
    }

    /// <summary>The place after the quote that closes a text, or the end of its line if no quote does.</summary>
    private static int EndOfText(ReadOnlySpan<byte> utf8, int start)
    {
        var i = start + 1;
        while (i < utf8.Length && utf8[i] is not ((byte)'"' or (byte)'\r' or (byte)'\n')) i += utf8[i] == '\\' ? 2 : 1;
        return Math.Min(i + 1, utf8.Length);
    }
}
