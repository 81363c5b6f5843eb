namespace RayCaster.Teaching;

/// <summary>The teacher's page: all students, the mistakes by frequency, and pictures that are wrong in the same way.</summary>
internal static class ClassPage
{
    private const int MostGroups = 40, MostNames = 12, MostToDiscuss = 3;

    /// <summary>Pictures look alike if the channels of their tiny copies differ by fewer levels than this on average.</summary>
    private const double AlikeLevels = 4;

    /// <summary>They are wrong in the same way if they also differ less from each other than from the right picture, by this factor.</summary>
    private const double AlikeShare = 0.25;

    /// <summary>The page as HTML. It names the mistakes, so it is not for students.</summary>
    public static string Of(Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        var page = new Page($"{rubric.Title}: {marks.Count} submissions");
        var open = Mean(marks, student => student.Open);
        page.Element("p",
            $"{Mean(marks, student => student.Points)} of {MarksTable.Number(rubric.Points)} points on average" +
            (open == "0" ? ". " : $", {open} more are open. ") +
            $"To look at yourself: {marks.Count(student => student.LookYourself.Count > 0)}.");
        AddMistakes(page, marks);
        AddLookYourself(page, marks);
        AddGroups(page, rubric, marks);
        AddEmpty(page, marks);
        AddTable(page, rubric, marks);
        return page.ToString();
    }

    private static string Mean(IReadOnlyList<StudentMarks> marks, Func<StudentMarks, double> points) =>
        MarksTable.Number(Math.Round(marks.Average(points), 2));

    private static void AddMistakes(Page page, IReadOnlyList<StudentMarks> marks)
    {
        (string Id, int Count)[] counts =
        [
            .. marks.SelectMany(student => student.Mistakes.Concat(student.NotDrawn)).CountBy(id => id)
                .Select(count => (count.Key, count.Value)).OrderByDescending(count => count.Value),
        ];
        page.Element("h2", "Mistakes by frequency");
        page.Element("p", counts.Length == 0 ? "No mistakes were found."
            : $"To discuss next: {string.Join("; ", counts.Take(MostToDiscuss).Select(count => ToDiscuss(count.Id)))}.");
        page.Html("<table><tr><th class=\"n\">Students</th><th>Mistake</th><th>What is wrong</th><th>Slide</th></tr>");
        foreach (var (id, count) in counts)
        {
            var mistake = MistakeCatalog.Named(id);
            page.Html($"<tr><td class=\"n\">{count}</td><td>{Page.Escaped(id)}</td><td>{Page.Escaped(mistake?.Cause ?? MarkWords.NotDrawn(id))}</td>"
                + $"<td>{Page.Escaped(mistake?.Slide ?? "")}</td></tr>");
        }
        page.Html("</table>");
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
        {
            var pictures = student.Scenes.Where(scene => scene.Verdict == SceneVerdict.Unexplained && scene.Small.Length > 0)
                .Select(scene => Page.Image(scene.Small, scene.Name));
            page.Html($"<tr><td>{Link(student)}</td><td class=\"long\">{string.Join("<br>", student.LookYourself.Select(Page.Escaped))}<br>" +
                $"{string.Join(' ', pictures)}</td></tr>");
        }
        page.Html("</table>");
    }

    private static void AddGroups(Page page, Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        var right = rubric.Scenes.ToDictionary(scene => scene.Name, scene => Thumbnail.Of(scene.Right, Thumbnail.Tiny).Rgb);
        var groups = new List<(SceneMarks First, List<StudentMarks> Students)>();
        foreach (var student in marks)
        {
            foreach (var scene in student.Scenes.Where(scene => scene.Likeness.Length > 0 && !IsOfOneColor(scene)))
            {
                var group = groups.Find(other =>
                    other.First.Name == scene.Name && AreAlike(other.First.Likeness, scene.Likeness, right[scene.Name]));
                if (group.Students is null) groups.Add((scene, [student]));
                else group.Students.Add(student);
            }
        }
        var large = groups.Where(group => group.Students.Count > 1).OrderByDescending(group => group.Students.Count).ToArray();
        if (large.Length == 0) return;
        page.Element("h2", "Pictures that are wrong in the same way");
        foreach (var (first, students) in large.Take(MostGroups))
        {
            page.Html($"<div class=\"tile\">{Page.Image(first.Small, first.Name)}<br>{Page.Escaped(first.Name)}, " +
                $"{students.Count} students<br><span class=\"small\">{Links(students)}</span></div>");
        }
        if (large.Length > MostGroups) page.Element("p", $"And {large.Length - MostGroups} smaller groups.");
    }

    /// <summary>Pictures of nothing but background, or all black: they are alike, but not for one reason.</summary>
    private static void AddEmpty(Page page, IReadOnlyList<StudentMarks> marks)
    {
        var scenes = marks.SelectMany(student => student.Scenes.Where(IsOfOneColor).Select(scene => (scene.Name, Student: student)))
            .GroupBy(empty => empty.Name, empty => empty.Student).OrderByDescending(scene => scene.Count()).ToArray();
        if (scenes.Length == 0) return;
        page.Element("h2", $"Empty pictures: {scenes.Sum(scene => scene.Count())}");
        foreach (var scene in scenes) page.Html($"<p>{Page.Escaped(scene.Key)}, {scene.Count()} of {marks.Count}: {Links([.. scene])}</p>");
    }

    private static bool IsOfOneColor(SceneMarks scene) =>
        scene.Likeness is { Length: > 0 } rgb && rgb.AsSpan(3).SequenceEqual(rgb.AsSpan(0, rgb.Length - 3));

    private static bool AreAlike(byte[] a, byte[] b, byte[] right)
    {
        var apart = Apart(a, b);
        return apart < AlikeLevels * a.Length && apart < AlikeShare * Math.Min(Apart(a, right), Apart(b, right));
    }

    private static double Apart(byte[] a, byte[] b) =>
        a.Length == b.Length ? a.Zip(b, (channel, other) => Math.Abs(channel - other)).Sum() : double.PositiveInfinity;

    private static void AddTable(Page page, Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        page.Element("h2", "All");
        page.Html("<div class=\"wide small\"><table><tr><th>Student</th><th class=\"n\">Points</th>" +
            $"{string.Concat(rubric.Items.Select(item => $"<th class=\"n\">{Page.Escaped(item.Name)}</th>"))}<th>Found</th></tr>");
        foreach (var student in marks)
        {
            var style = student.Open > 0 ? "open" : student.Points < rubric.Points ? "lost" : "";
            var items = string.Concat(student.Items.Select(item => $"<td class=\"n\">{MarksTable.Item(item)}</td>"));
            var found = string.Join(", ", student.NotDrawn.Select(part => "no " + part).Concat(student.Mistakes))
                + (student.Losing.Count > 0 ? $" (or {string.Join(" or ", student.Losing)})" : "");
            page.Html($"<tr class=\"{style}\"><td>{Link(student)}</td><td class=\"n\">{MarksTable.Number(student.Points)}" +
                $"{(student.Open > 0 ? $" + {MarksTable.Number(student.Open)}?" : "")}</td>{items}<td>{Page.Escaped(found)}</td></tr>");
        }
        page.Html("</table></div>");
    }

    private static string Links(List<StudentMarks> students) => string.Join(", ", students.Take(MostNames).Select(Link)) +
        (students.Count > MostNames ? $" and {students.Count - MostNames} more" : "");

    private static string Link(StudentMarks student) =>
        $"<a href=\"{Page.Escaped(Uri.EscapeDataString(student.Student))}/feedback.html\">{Page.Escaped(student.Student)}</a>";
}
