namespace RayCaster.Files;

/// <summary>The statements of an OBJ file that are not read although they may shape the mesh: their count, their kinds, the first line.</summary>
internal sealed class SkippedStatements
{
    private const int MostKinds = 1000, Named = 5;

    private static readonly string[] freeForm = ["cstype", "curv", "curv2", "surf", "bsp", "bzp"]; // a file with such forms has one of them
    private static readonly string[] harmless = ["mg", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "maplib", "usemap"];

    private readonly List<string> kinds = [];
    private readonly HashSet<string> known = [];
    private int count, firstLine;

    public void Add(ReadOnlySpan<byte> statement, TextScanner scanner)
    {
        if (statement.Length <= 10 && harmless.Contains(Encoding.UTF8.GetString(statement))) return;
        if (count++ == 0) firstLine = scanner.LineNumber;
        if (known.Count < MostKinds && known.Add(scanner.Quoted)) kinds.Add(scanner.Quoted);
    }

    public string? Warning
    {
        get
        {
            if (count == 0) return null;
            var names = string.Join(", ", kinds.Take(Named)) + (kinds.Count > Named ? " …" : "");
            var atLeast = kinds.Count == MostKinds ? "at least " : "";
            return $"{Digits.Count(count, "line")} of {atLeast}{Digits.Count(kinds.Count, "unknown kind")} {(count == 1 ? "is" : "are")} " +
                $"skipped ({names}), "
                + $"first in line {firstLine} of the file"
                + (kinds.Exists(kind => freeForm.Contains(kind.Trim('\''))) ? "; free-form curves and surfaces are not read" : "")
                + (kinds.Exists(kind => JsonForeign.IsMergeMarker(Encoding.UTF8.GetBytes(kind.Trim('\'')))) ? $"; this is {JsonForeign.Merge}"
                    : "");
        }
    }
}
