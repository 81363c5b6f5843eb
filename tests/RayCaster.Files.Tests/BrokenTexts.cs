using System.Text.RegularExpressions;

namespace RayCaster.Files.Tests;

/// <summary>The tables Broken/Meshes.txt and Broken/Pictures.txt: a broken file and its message in each line.</summary>
internal static class BrokenTexts
{
    public static TheoryData<string> Rows(string table) => [.. Lines(table).Where(line => line.Contains(" | "))];

    /// <summary>The columns of a row, the last one being the message.</summary>
    public static string[] Columns(string table, string row)
    {
        foreach (var definition in Lines(table).Where(line => line.StartsWith('{') && !line.Contains(" | ")))
            row = row.Replace(definition.Split(" = ")[0], definition.Split(" = ")[1]);
        return Array.ConvertAll(row.Split(" | "), Regex.Unescape);
    }

    private static IEnumerable<string> Lines(string table) =>
        File.ReadLines(ProjectFolder.PathOf($"tests/RayCaster.Files.Tests/Broken/{table}")).Where(line => line.Length > 0 && line[0] != '#');
}
