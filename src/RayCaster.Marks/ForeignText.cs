using System.Text.Unicode;

namespace RayCaster.Marks;

/// <summary>Text as other programs save it.</summary>
internal static class ForeignText
{
    /// <summary>The text of bytes in UTF-8, UTF-16 or else Windows-1252: what an XML file says of its encoding may be wrong.</summary>
    public static string Decode(byte[] bytes)
    {
        var encoding = bytes is [not 0, 0, ..] ? Encoding.Unicode : bytes is [0, not 0, ..] ? Encoding.BigEndianUnicode
            : Utf8.IsValid(bytes) ? Encoding.UTF8 : CodePagesEncodingProvider.Instance.GetEncoding(1252)!;
        using var reader = new StreamReader(new MemoryStream(bytes), encoding); // a byte order mark wins
        return reader.ReadToEnd();
    }
}
