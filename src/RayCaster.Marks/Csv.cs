using System.Text.RegularExpressions;

namespace RayCaster.Marks;

/// <summary>Reads a table as spreadsheets save it: cells between commas, semicolons or tabs, in UTF-8, UTF-16 or Windows-1252.</summary>
internal static class Csv
{
    private const int MaxBytes = 1 << 26;

    /// <summary>The rows with their cells; empty rows, too, so that they count as in a spreadsheet.</summary>
    /// <exception cref="ProblemException">The file cannot be read.</exception>
    public static List<List<string>> Read(string path)
    {
        try
        {
            return Rows(ForeignText.Decode([.. InputFile.Read(path, "table", MaxBytes)]));
        }
        catch (ProblemException e)
        {
            throw new ProblemException($"cannot read {path}: {e.Message}", e);
        }
    }

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
