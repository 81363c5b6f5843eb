namespace RayCaster.Marks;

/// <summary>The teacher's page: the mistake that most make, what to look at, all mistakes by frequency, and all students. It names the mistakes, so
/// it is not for students.</summary>
internal static class ClassPage
{
    public static string Create(Rubric rubric, IReadOnlyList<StudentMarks> marks)
    {
        var page = new Page($"{rubric.Title}: {marks.Count} submissions");
        var mistakes = marks.SelectMany(student => student.Mistakes.Concat(student.MissingParts).Select(id => (id, student)))
            .GroupBy(made => made.id, made => made.student).OrderByDescending(made => made.Count()).ToArray();
        if (mistakes is [var most, ..])
            page.Element("h2", $"Most often: {Cause(most.Key)}")
                .Html($"<p>{most.Count()} of {marks.Count}: {Links(most)}</p>")
                .Html($"<p class=\"beside\">{Pictures(rubric, most.Key)}</p>");
        var undecided = Mean(marks, student => student.Undecided);
        page.Element("p", $"{Mean(marks, student => student.Points)} of {MarksTable.Number(rubric.Points)} points on average" +
            $"{(undecided == "0" ? "" : $"; {undecided} undecided")}. " +
            $"To look at yourself: {marks.Count(student => student.LookYourself.Count > 0)}.");

        page.Table("Look yourself", ["Student", "Why"], [.. marks.Where(student => student.LookYourself.Count > 0).Select(student =>
            $"<tr><td>{Link(student)}</td><td class=\"long\">{string.Join("<br>", student.LookYourself.Select(Page.Escaped))}</td></tr>")]);
        page.Table("Mistakes by frequency", ["Students", "Mistake", "What is wrong", "Slide", "What it draws, and the right picture"],
            [.. mistakes.Select(made =>
                $"<tr><td class=\"n\">{made.Count()}</td><td>{Page.Escaped(made.Key)}</td><td>{Page.Escaped(Cause(made.Key))}</td><td>" +
                $"{Page.Escaped(MistakeCatalog.Named(made.Key)?.Slide ?? "")}</td><td class=\"beside\">{Pictures(rubric, made.Key)}</td></tr>")]);
        page.Table("The same wrong pictures, to the byte: the same mistake draws the same", ["Students", "Scenes"], SamePictures(marks));
        page.Table("All", ["Student", "Points", .. rubric.Items.Select(item => item.Name), "Found"],
            [.. marks.Select(student => Row(rubric, student))]);
        return page.ToString();
    }

    private static string Mean(IReadOnlyList<StudentMarks> marks, Func<StudentMarks, double> points) =>
        MarksTable.Number(Math.Round(marks.Average(points), 2));

    private static string Cause(string id) => MistakeCatalog.Named(id)?.Cause ?? MarkWords.NotWritten(id);

    /// <summary>What a mistake makes of the scene that it changes most, as small pictures show, beside the right picture.</summary>
    private static string Pictures(Rubric rubric, string id)
    {
        var change = MistakeCatalog.Named(id)?.Usual ?? MissingPart.Without(id);
        var clearest = rubric.Scenes.MaxBy(scene => Change(scene.Scene.WithSize(scene.Right.Width / 4 + 1, scene.Right.Height / 4 + 1)))!;
        return $"{Page.Image(MistakeCatalog.Draw(clearest.Scene, [change]), $"{clearest.Name} with {id}")} " +
            Page.Image(clearest.Right, $"{clearest.Name}, right");

        double Change(Scene scene)
        {
            var right = Renderer.Render(scene);
            var wrong = MistakeCatalog.Draw(scene, [change]);
            return (wrong.Width, wrong.Height) != (right.Width, right.Height)
                ? byte.MaxValue : new PictureDifference(wrong, right).MeanAbsoluteError;
        }
    }

    private static string[] SamePictures(IReadOnlyList<StudentMarks> marks) =>
    [
        .. marks.SelectMany(student => student.Scenes.Where(scene => scene.Digest is not null).Select(scene => (scene, student)))
            .GroupBy(one => (one.scene.Name, one.scene.Digest), one => one.student).Where(same => same.Count() > 1)
            .GroupBy(Links, same => same.Key.Name)
            .Select(same => $"<tr><td>{same.Key}</td><td>{Page.Escaped(string.Join(", ", same))}</td></tr>"),
    ];

    private static string Row(Rubric rubric, StudentMarks student)
    {
        var style = student.Undecided > 0 ? "undecided" : student.Points < rubric.Points ? "lost" : "";
        var items = string.Concat(student.Items.Select(item => $"<td class=\"n\">{MarksTable.Item(item)}</td>"));
        var found = string.Join(", ", student.MissingParts.Select(part => "no " + part).Concat(student.Mistakes))
            + (student.HidingMistakes.Count > 0 ? $" (or {string.Join(" or ", student.HidingMistakes)})" : "");
        return $"<tr class=\"{style}\"><td>{Link(student)}</td><td class=\"n\">{MarksTable.Number(student.Points)}" +
            $"{(student.Undecided > 0 ? $" + {MarksTable.Number(student.Undecided)}?" : "")}</td>{items}<td>{Page.Escaped(found)}</td></tr>";
    }

    private static string Link(StudentMarks student) =>
        $"<a href=\"{Page.Escaped(Uri.EscapeDataString(student.Student))}/feedback.html\">{Page.Escaped(student.Student)}</a>";

    private static string Links(IEnumerable<StudentMarks> students) => string.Join(", ", students.Select(Link));
}
