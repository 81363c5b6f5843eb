namespace RayCaster.Marks;

/// <summary>What a teacher has entered into a student's row of the table. It wins over what is computed.</summary>
internal sealed record TeacherDecision(double? Points, string Comment);

/// <summary>Reads the table of the last run, into which a teacher has entered points and comments.</summary>
internal static class TeacherTable
{
    /// <summary>How many wrong rows a message lists, and how many folders it names for each.</summary>
    private const int MaxRows = 5, MaxNearest = 3;

    /// <summary>What the teacher has entered, by student; empty if there is no table yet.</summary>
    /// <param name="students">The names of the folders of which each row must have one.</param>
    /// <exception cref="ProblemException">The table cannot be read, or not all of its rows fit a folder.</exception>
    public static Dictionary<string, TeacherDecision> Read(string path, IReadOnlyCollection<string> students)
    {
        if (!File.Exists(path) || Csv.Read(path) is not [var head, .. var rows]) return [];
        var name = head.IndexOf(MarksTable.StudentColumn);
        var points = head.IndexOf(MarksTable.PointsColumn);
        var comment = head.IndexOf(MarksTable.CommentColumn);
        if (name < 0 || points < 0 || comment < 0)
            throw new ProblemException($"{path} has no column \"{MarksTable.StudentColumn}\", \"{MarksTable.PointsColumn}\" or " +
                $"\"{MarksTable.CommentColumn}\": rename or delete it, and it is written anew");
        var decisions = new Dictionary<string, TeacherDecision>();
        var wrong = new List<string>();
        foreach (var (i, row) in rows.Index())
        {
            var written = Cell(row, name);
            if (row.TrueForAll(cell => cell.Trim() == "")) continue;
            if (Folder(written, students) is not { } student)
            {
                wrong.Add($"\n  row {i + 2}: {PrintableText.From(written)}{Nearest(written, students)}");
                student = written;
            }
            if (Decision(path, student, Cell(row, points), Cell(row, comment)) is not { } decision) continue;
            if (!decisions.TryAdd(student, decision) && decisions[student] != decision)
                throw new ProblemException($"{path} has two rows of {PrintableText.From(student)} that say different things: delete one of them");
        }
        if (wrong.Count == 0) return decisions;
        throw new ProblemException($"{path}: {(wrong.Count == 1 ? "a row fits" : $"{wrong.Count} rows fit")} no folder, so nothing was written" +
            string.Concat(wrong.Take(MaxRows)) + (wrong.Count > MaxRows ? $"\n  and {wrong.Count - MaxRows} more" : "") +
            "\n  Correct the names, or delete the rows.");
    }

    /// <summary>The folder of a row; null if none fits, or several do. Programs write é as one character or as two.</summary>
    private static string? Folder(string row, IReadOnlyCollection<string> students) => students.Contains(row) ? row
        : students.Where(student => Accents.AreEquivalent(student, row)).ToArray() is [var only] ? only : null;

    private static TeacherDecision? Decision(string path, string student, string points, string comment)
    {
        var isNumber = double.TryParse(points.Replace(',', '.'), NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
            && double.IsFinite(number);
        if (!isNumber && points != "")
            throw new ProblemException(
                $"{path}: the {MarksTable.PointsColumn} of {PrintableText.From(student)} must be a number, but is \"{PrintableText.From(points)}\"");
        return isNumber || comment != "" ? new(isNumber ? number : null, comment) : null;
    }

    /// <summary>The folders that a row may mean, and what a spreadsheet does to names that look like numbers.</summary>
    private static string Nearest(string row, IReadOnlyCollection<string> students)
    {
        if (students.FirstOrDefault(student => IsSameNumber(row, student)) is { } number)
            return $"; there is {number}: the spreadsheet took the name for a number. Format the column as text, then write {number}";
        var nearest = new List<string>();
        while (nearest.Count < MaxNearest && Spelling.Nearest(row, students.Except(nearest)) is { } student) nearest.Add(student);
        return nearest.Count == 0 ? "; no folder has a similar name" : $"; the nearest: {string.Join(", ", nearest)}";
    }

    /// <summary>Whether a spreadsheet may have made one of the other: 00123 becomes 123, and 123456789012 becomes 1.23457E+11.</summary>
    private static bool IsSameNumber(string row, string student) =>
        double.TryParse(row.Replace(',', '.'), NumberStyles.Float, CultureInfo.InvariantCulture, out var one)
            && double.TryParse(student, NumberStyles.Float, CultureInfo.InvariantCulture, out var other)
            && Math.Abs(one - other) <= (row.Contains('E') ? 1e-5 * other : 0);

    /// <summary>A cell, without the apostrophe that <see cref="MarksTable"/> has put before a formula.</summary>
    private static string Cell(List<string> row, int column) => column >= row.Count ? ""
        : row[column].Trim() is ['\'', var first, ..] text && MarksTable.Formula.Contains(first) ? text[1..] : row[column].Trim();
}
