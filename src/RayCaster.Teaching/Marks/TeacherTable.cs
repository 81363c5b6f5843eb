namespace RayCaster.Teaching;

/// <summary>What a teacher has entered into a student's row of the table. It wins over what is computed.</summary>
internal sealed record TeacherDecision(double? Points, string Comment);

/// <summary>Reads tables that a teacher has edited: the marks of the last run, and the ids of students. Spreadsheets save them with commas,
/// semicolons or tabs, in UTF-8 or in Latin-1.</summary>
internal static class TeacherTable
{
    public const string PointsColumn = "teacher's points", CommentColumn = "comment";

    private const long MaxBytes = 1 << 26;

    /// <summary>What the teacher has entered, by student; empty if there is no table yet.</summary>
    /// <exception cref="ProblemException">The table cannot be read.</exception>
    public static Dictionary<string, TeacherDecision> Decisions(string path)
    {
        if (!File.Exists(path) || Rows(path) is not [var head, .. var rows]) return [];
        var (name, points, comment) = (head.IndexOf("student"), head.IndexOf(PointsColumn), head.IndexOf(CommentColumn));
        if (name < 0 || points < 0 || comment < 0)
            throw new ProblemException($"{path} has no column \"student\", \"{PointsColumn}\" or \"{CommentColumn}\": " +
                "rename or delete it, and it is written anew");
        var decisions = new Dictionary<string, TeacherDecision>();
        foreach (var row in rows)
        {
            var (student, written, words) = (Cell(row, name), Cell(row, points).Replace(',', '.'), Cell(row, comment));
            var isNumber = double.TryParse(written, NumberStyles.Float, CultureInfo.InvariantCulture, out var number) && double.IsFinite(number);
            if (!isNumber && written != "")
                throw new ProblemException($"{path}: the {PointsColumn} of {PrintableText.Of(student)} must be a number, but is \"{written}\"");
            if (!isNumber && words == "") continue;
            var decision = new TeacherDecision(isNumber ? number : null, words);
            if (!decisions.TryAdd(student, decision) && decisions[student] != decision)
                throw new ProblemException($"{path} has two rows of {PrintableText.Of(student)} that say different things: delete one of them");
        }
        return decisions;
    }

    /// <summary>The ids of a file whose first two columns are a submission's folder and the id by which rows and pages are named.</summary>
    /// <exception cref="ProblemException">The file cannot be read, or two folders have the same id.</exception>
    public static Dictionary<string, string> Ids(string path)
    {
        if (!File.Exists(path)) throw new ProblemException($"there is no file of ids {path}");
        var ids = new Dictionary<string, string>();
        foreach (var row in Rows(path))
        {
            if (Cell(row, 0) == "" || Cell(row, 1) == "") continue;
            if (ids.ContainsValue(Cell(row, 1))) throw new ProblemException($"{path} has the id {PrintableText.Of(Cell(row, 1))} twice");
            ids[Cell(row, 0)] = Cell(row, 1);
        }
        return ids;
    }

    /// <summary>A cell, without the apostrophe that <see cref="MarksTable"/> has put before a formula.</summary>
    private static string Cell(List<string> row, int column) => column >= row.Count ? ""
        : row[column].Trim() is ['\'', var first, ..] text && MarksTable.Formula.Contains(first) ? text[1..] : row[column].Trim();

    private static List<List<string>> Rows(string path)
    {
        var bytes = RegularFile.Read(path, MaxBytes) ?? throw new ProblemException(
            $"cannot read {path}: it must be a file, no link, of {MaxBytes >> 20} MB at most");
        var text = (System.Text.Unicode.Utf8.IsValid(bytes) ? Encoding.UTF8 : Encoding.Latin1).GetString(bytes).TrimStart('\uFEFF');
        var (rows, row, cell, isQuoted, separator) = (new List<List<string>>(), new List<string>(), new StringBuilder(), false, default(char?));
        for (var i = 0; i < text.Length; i++)
        {
            var c = text[i];
            if (c == '"' && isQuoted && text.AsSpan(i + 1) is ['"', ..]) cell.Append(text[i++]);
            else if (c == '"' && (isQuoted || cell.Length == 0)) isQuoted = !isQuoted;
            else if (isQuoted || !IsEnd(c)) cell.Append(c);
            else EndCell(c is '\r' or '\n');
        }
        if (isQuoted) throw new ProblemException($"cannot read {path}: a cell begins with a quote (\") and does not end with one");
        EndCell(true);
        return rows;

        bool IsEnd(char c) => c is '\r' or '\n' || (c is ',' or ';' or '\t' && c == (separator ??= c));

        void EndCell(bool isLast)
        {
            row.Add(cell.ToString());
            cell.Clear();
            if (!isLast) return;
            if (row.Exists(one => one != "")) rows.Add(row);
            row = [];
        }
    }
}
