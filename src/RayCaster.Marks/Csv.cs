using System.Text.RegularExpressions;

namespace RayCaster.Marks;

/// <summary>Reads a table as spreadsheets save it: cells between commas, semicolons or tabs, in UTF-8, UTF-16 or Windows-1252.</summary>
internal static class Csv
{
    private const int MaxBytes = 1 << 26;

    /// <summary>The characters 80 to 9F of Windows-1252; the others are those of Latin-1.</summary>
    private const string From80To9F = "€\u0081‚ƒ„…†‡ˆ‰Š‹Œ\u008DŽ\u008F\u0090‘’“”•–—˜™š›œ\u009DžŸ";

    /// <summary>The rows with their cells; empty rows, too, so that they count as in a spreadsheet.</summary>
    /// <exception cref="ProblemException">The file cannot be read.</exception>
    public static List<List<string>> Read(string path)
    {
        try
        {
            return Rows(Text(InputFile.Read(path, "table", MaxBytes)).TrimStart('\uFEFF'));
        }
        catch (ProblemException e)
        {
            throw new ProblemException($"cannot read {path}: {e.Message}", e);
        }
    }

    private static string Text(ReadOnlySpan<byte> bytes) => bytes switch
    {
        [0xFF, 0xFE, ..] or [not 0, 0, ..] => Encoding.Unicode.GetString(bytes),
        [0xFE, 0xFF, ..] or [0, not 0, ..] => Encoding.BigEndianUnicode.GetString(bytes),
        _ when System.Text.Unicode.Utf8.IsValid(bytes) => Encoding.UTF8.GetString(bytes),
        _ => string.Concat(Encoding.Latin1.GetString(bytes).Select(c => c is >= '\u0080' and <= '\u009F' ? From80To9F[c - '\u0080'] : c)),
    };

    /// <summary>The first separator in the text is the one of the table.</summary>
    private static List<List<string>> Rows(string text)
    {
        var separator = text.AsSpan().IndexOfAny(",;\t") is >= 0 and var at ? text[at] : ',';
        var rows = new List<List<string>> { new() };
        var cells = new Regex($"""\G(?:"(?<quoted>(?>(?:[^"]|"")*))"|(?<plain>[^{separator}\r\n]*))(?<end>{separator}|\r?\n|\r|\z)""");
        foreach (Match cell in cells.Matches(text))
        {
            if (cell.Groups["plain"].Value.StartsWith('"')) throw new ProblemException("a cell begins with a quote (\") and does not end with one");
            rows[^1].Add(cell.Groups["plain"].Value + cell.Groups["quoted"].Value.Replace("\"\"", "\""));
            if (cell.Groups["end"].Value != $"{separator}") rows.Add([]);
        }
        return rows;
    }
}
