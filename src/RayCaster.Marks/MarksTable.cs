namespace RayCaster.Marks;

/// <summary>The marks as a table for a spreadsheet: CSV (RFC 4180) with decimal points, and a byte order mark, without which Excel takes UTF-8 for
/// another encoding.</summary>
internal static class MarksTable
{
    public const string StudentColumn = "student", PointsColumn = "teacher's points", CommentColumn = "comment";

    /// <summary>The characters with which a formula may begin.</summary>
    public const string Formula = "=+-@\t\r";

    /// <summary>A header line, and a line for each student. Items that are not decided have a question mark.</summary>
    public static string Format(Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        string[] head =
        [
            StudentColumn, "points", "undecided", "of", PointsColumn, CommentColumn,
            .. rubric.Items.Select(item => item.Name), "look yourself", "not drawn yet", "mistakes", "right pictures",
        ];
        var lines = marks.Select(student => (string[])
        [
            student.Student, Number(student.Points), Number(student.Undecided), Number(rubric.Points),
            Number(student.TeacherPoints), student.Comment, .. student.Items.Select(Item),
            string.Join("; ", student.LookYourself), string.Join(" ", student.MissingParts), string.Join(" ", student.Mistakes),
            $"{student.RightPictures} of {student.Scenes.Count}",
        ]);
        return "\uFEFF" + string.Concat(lines.Prepend(head).Select(cells => string.Join(',', cells.Select(Cell)) + "\r\n"));
    }

    /// <summary>Points, with at most two decimals; empty for none.</summary>
    public static string Number(double? points) => points?.ToString("0.##", CultureInfo.InvariantCulture) ?? "";

    /// <summary>An item's certain points, with a question mark if more are not decided.</summary>
    public static string Item(ItemMarks item) => item.Undecided > 0 ? $"{Number(item.Points)}?" : Number(item.Points);

    /// <summary>
    /// A cell, in quotes if necessary. A text that begins like a formula gets an apostrophe, because a spreadsheet would run it, and
    /// a student may name a folder so. No other control characters are in it.
    /// </summary>
    private static string Cell(string text)
    {
        text = string.Concat(text.Select(c => char.IsControl(c) && c is not ('\t' or '\r' or '\n') ? '\uFFFD' : c));
        if (text is [var first, ..] && Formula.Contains(first)) text = "'" + text;
        return text.AsSpan().ContainsAny(",;\t\"\r\n") ? $"\"{text.Replace("\"", "\"\"")}\"" : text;
    }
}
