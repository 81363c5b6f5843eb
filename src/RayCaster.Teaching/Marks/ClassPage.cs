namespace RayCaster.Teaching;

/// <summary>The teacher's page: all students, the mistakes by frequency, and what to look at.</summary>
internal static class ClassPage
{
    private const int MaxToDiscuss = 3;

    /// <summary>The page as HTML. It names the mistakes, so it is not for students.</summary>
    public static string Of(Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        var page = new Page($"{rubric.Title}: {marks.Count} submissions");
        var undecided = Mean(marks, student => student.Undecided);
        page.Element("p",
            $"{Mean(marks, student => student.Points)} of {MarksTable.Number(rubric.Points)} points on average" +
            (undecided == "0" ? ". " : $"; {undecided} undecided. ") +
            $"To look at yourself: {marks.Count(student => student.LookYourself.Count > 0)}.");
        AddMistakes(page, rubric, marks);
        AddLookYourself(page, marks);
        AddTable(page, rubric, marks);
        return page.ToString();
    }

    private static string Mean(IReadOnlyList<StudentMarks> marks, Func<StudentMarks, double> points) =>
        MarksTable.Number(Math.Round(marks.Average(points), 2));

    private static void AddMistakes(Page page, Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        (string Id, int Count)[] counts =
        [
            .. marks.SelectMany(student => student.Mistakes.Concat(student.NotDrawn)).CountBy(id => id)
                .Select(count => (count.Key, count.Value)).OrderByDescending(count => count.Value),
        ];
        page.Element("h2", "Mistakes by frequency");
        page.Element("p", counts.Length == 0 ? "No mistakes were found."
            : $"To discuss next: {string.Join("; ", counts.Take(MaxToDiscuss).Select(count => ToDiscuss(count.Id)))}.");
        page.Html($"<div class=\"wide\"><table><tr>{Page.Head("Students", true)}{Page.Head("Mistake")}{Page.Head("What is wrong")}"
            + $"{Page.Head("Slide")}{Page.Head("What it draws, and the right picture")}</tr>");
        foreach (var (id, count) in counts)
        {
            var mistake = MistakeCatalog.Named(id);
            page.Html($"<tr><td class=\"n\">{count}</td><td>{Page.Escaped(id)}</td><td>{Page.Escaped(mistake?.Cause ?? MarkWords.NotDrawn(id))}</td>"
                + $"<td>{Page.Escaped(mistake?.Slide ?? "")}</td><td class=\"beside\">{Pictures(rubric, id)}</td></tr>");
        }
        page.Html("</table></div>");
    }

    /// <summary>What a mistake makes of the scene that it changes most, beside the right picture; empty if no scene shows it.</summary>
    private static string Pictures(Rubric rubric, string id)
    {
        var mistake = MistakeCatalog.Named(id);
        var program = mistake is null ? new WrongProgram(new([id]), [], false) : new WrongProgram(Unfinished.Nothing, [mistake], false);
        var clearest = rubric.Scenes.Where(scene => mistake is null ? scene.Needs(id) : scene.Shows(id))
            .Select(scene => new { scene.Name, scene.Right, Wrong = program.Draw(scene.Scene).Render() })
            .MaxBy(scene => (scene.Wrong.Width, scene.Wrong.Height) != (scene.Right.Width, scene.Right.Height) ? byte.MaxValue
                : new PictureDifference(scene.Wrong, scene.Right).MeanAbsoluteError);
        return clearest is null ? ""
            : $"{Page.Image(clearest.Wrong, $"{clearest.Name} with {id}")} {Page.Image(clearest.Right, $"{clearest.Name}, right")}";
    }

    private static string ToDiscuss(string id) =>
        MistakeCatalog.Named(id) is { } mistake ? $"{mistake.Cause} (slide \"{mistake.Slide}\")" : MarkWords.NotSeen(id);

    private static void AddLookYourself(Page page, IReadOnlyList<StudentMarks> marks)
    {
        var flagged = marks.Where(student => student.LookYourself.Count > 0).ToArray();
        if (flagged.Length == 0) return;
        page.Element("h2", "Look yourself");
        page.Html("<table>");
        foreach (var student in flagged)
            page.Html($"<tr><td>{Link(student)}</td><td class=\"long\">{string.Join("<br>", student.LookYourself.Select(Page.Escaped))}</td></tr>");
        page.Html("</table>");
    }

    private static void AddTable(Page page, Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        page.Element("h2", "All");
        page.Html($"<div class=\"wide small\"><table><tr>{Page.Head("Student")}{Page.Head("Points", true)}" +
            $"{string.Concat(rubric.Items.Select(item => Page.Head(item.Name, true)))}{Page.Head("Found")}</tr>");
        foreach (var student in marks)
        {
            var style = student.Undecided > 0 ? "undecided" : student.Points < rubric.Points ? "lost" : "";
            var items = string.Concat(student.Items.Select(item => $"<td class=\"n\">{MarksTable.Item(item)}</td>"));
            var found = string.Join(", ", student.NotDrawn.Select(part => "no " + part).Concat(student.Mistakes))
                + (student.Losing.Count > 0 ? $" (or {string.Join(" or ", student.Losing)})" : "");
            page.Html($"<tr class=\"{style}\"><td>{Link(student)}</td><td class=\"n\">{MarksTable.Number(student.Points)}" +
                $"{(student.Undecided > 0 ? $" + {MarksTable.Number(student.Undecided)}?" : "")}</td>{items}<td>{Page.Escaped(found)}</td></tr>");
        }
        page.Html("</table></div>");
    }

    private static string Link(StudentMarks student) =>
        $"<a href=\"{Page.Escaped(Uri.EscapeDataString(student.Student))}/feedback.html\">{Page.Escaped(student.Student)}</a>";
}
