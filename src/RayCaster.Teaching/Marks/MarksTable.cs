namespace RayCaster.Teaching;

/// <summary>The marks as a table for a spreadsheet: CSV (RFC 4180) with decimal points, and a byte order mark, without which Excel takes UTF-8 for
/// another encoding.</summary>
internal static class MarksTable
{
    /// <summary>The characters with which a formula may begin.</summary>
    public const string Formula = "=+-@\t\r";

    /// <summary>A header line, and a line for each student. Items that are not decided have a question mark.</summary>
    /// <param name="others">What a teacher has decided for students without a submission.</param>
    public static string Of(Rubric rubric, IReadOnlyList<StudentMarks> marks, IEnumerable<KeyValuePair<string, TeacherDecision>> others)
    {
        string[] head =
        [
            "student", "points", "undecided", "of", TeacherTable.PointsColumn, TeacherTable.CommentColumn,
            .. rubric.Items.Select(item => item.Name), "look yourself", "not drawn yet", "mistakes", "right pictures",
        ];
        var lines = marks.Select(student => (string[])
        [
            student.Student, Number(student.Points), Number(student.Undecided), Number(rubric.Points),
            Number(student.TeacherPoints), student.Comment ?? "", .. student.Items.Select(Item),
            string.Join("; ", student.LookYourself), string.Join(" ", student.NotDrawn), string.Join(" ", student.Mistakes),
            $"{student.RightPictures} of {student.Scenes.Count}",
        ]);
        var rest = others.Select(other => (string[])
            [other.Key, Number(other.Value.Points), "", Number(rubric.Points), Number(other.Value.Points), other.Value.Comment]);
        return "\uFEFF" + Text([head, .. lines, .. rest]);
    }

    /// <summary>A table that Moodle's grade import takes. Points that are not all decided are left empty.</summary>
    public static string ForMoodle(Rubric rubric, IReadOnlyList<StudentMarks> marks) => Text(
    [
        [marks.All(student => IsLogin(student.Student)) ? "Email address" : "ID number", rubric.Title, "Feedback"],
        .. marks.Select(student => (string[])[student.Student, Decided(student), student.Comment ?? ""]),
    ]);

    /// <summary>A table that Canvas's gradebook import takes.</summary>
    public static string ForCanvas(Rubric rubric, IReadOnlyList<StudentMarks> marks) => Text(
    [
        ["Student", "ID", "SIS User ID", "SIS Login ID", "Section", rubric.Title],
        ["    Points Possible", "", "", "", "", Number(rubric.Points)],
        .. marks.Select(student => (string[])
        [
            student.Student, "", IsLogin(student.Student) ? "" : student.Student, IsLogin(student.Student) ? student.Student : "", "",
            Decided(student),
        ]),
    ]);

    private static bool IsLogin(string student) => student.Contains('@');

    private static string Decided(StudentMarks student) => student.Undecided > 0 ? "" : Number(student.Points);

    private static string Text(IEnumerable<string[]> rows) => string.Concat(rows.Select(cells => string.Join(',', cells.Select(Cell)) + "\r\n"));

    /// <summary>Points, with at most two decimals; empty for none.</summary>
    public static string Number(double? points) => points?.ToString("0.##", CultureInfo.InvariantCulture) ?? "";

    /// <summary>An item's certain points, with a question mark if more are not decided.</summary>
    public static string Item(ItemMarks item) => item.Undecided > 0 ? $"{Number(item.Points)}?" : Number(item.Points);

    /// <summary>
    /// A cell, in quotes if necessary. A text that begins like a formula gets an apostrophe, because a spreadsheet would run it, and
    /// a student may name a folder so.
    /// </summary>
    private static string Cell(string text)
    {
        if (text is [var first, ..] && Formula.Contains(first)) text = "'" + text;
        return text.AsSpan().ContainsAny(",;\t\"\r\n") ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
    }
}
