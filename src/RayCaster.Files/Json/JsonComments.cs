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
}
