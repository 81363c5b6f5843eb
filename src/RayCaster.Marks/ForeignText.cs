using System.Text.Unicode;

namespace RayCaster.Marks;

/// <summary>Text as other programs save it.</summary>
internal static class ForeignText
{
    private static readonly Encoding cyrillic = CodePagesEncodingProvider.Instance.GetEncoding(1251)!;

    /// <summary>The text of bytes in UTF-8, UTF-16 or else Windows-1252: what an XML file says of its encoding may be wrong.</summary>
    public static string Decode(byte[] bytes)
    {
        var encoding = bytes is [not 0, 0, ..] ? Encoding.Unicode : bytes is [0, not 0, ..] ? Encoding.BigEndianUnicode
            : Utf8.IsValid(bytes) ? Encoding.UTF8 : CodePagesEncodingProvider.Instance.GetEncoding(1252)!;
        using var reader = new StreamReader(new MemoryStream(bytes), encoding); // a byte order mark wins
        return reader.ReadToEnd();
    }

    /// <summary>A name in which é is e and an accent, whether it is encoded as one character or as two. (Without ICU the runtime does not normalise
    /// texts; but Windows-1251, which has no é, writes e.)</summary>
    public static string WithAccentsApart(string name)
    {
        var text = new StringBuilder();
        foreach (var c in name)
        {
            var plain = cyrillic.GetString(cyrillic.GetBytes([c]))[0];
            if (CharUnicodeInfo.GetUnicodeCategory(c) == UnicodeCategory.NonSpacingMark) text.Append('\'');
            else if (plain != c && char.IsAsciiLetter(plain)) text.Append(plain).Append('\'');
            else text.Append(c);
        }
        return text.ToString();
    }
}
