using System.Text.RegularExpressions;

namespace RayCaster.Teaching.Tests.Mistakes;

/// <summary>Tables of tests in text files: a line is a row, "|" stands between its cells, and what begins with "#" is a comment.</summary>
internal static partial class TestTable
{
    /// <summary>The rows of a file; those that begin with "*" are tried only when explicit tests are asked for.</summary>
    /// <param name="file">Relative to this project's folder.</param>
    public static IEnumerable<ITheoryDataRow> Read(string file) =>
        File.ReadLines(ProjectFolder.PathOf($"tests/RayCaster.Teaching.Tests/{file}"))
            .Where(line => line.Length > 0 && line[0] != '#')
            .Select(line => new TheoryDataRow(Separator().Split(line.TrimStart('*', ' ')).Select(cell => (object)cell.Trim()).ToArray())
            {
                Explicit = line[0] == '*' ? true : null, // otherwise as the test says
            });

    /// <summary>And not C#'s "or".</summary>
    [GeneratedRegex(@"(?<!\|)\|(?!\|)")]
    private static partial Regex Separator();
}
