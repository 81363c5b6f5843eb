namespace RayCaster.Marks;

/// <summary>A student's page: points, hints, and each picture beside the right one. It has no answers.</summary>
internal static class FeedbackPage
{
    public static string Create(Rubric rubric, StudentMarks marks, IReadOnlyList<SubmittedPicture> pictures)
    {
        var page = new Page($"{rubric.Title}: {marks.Student}");
        page.Element("p", $"{marks.RightPictures} of {marks.Scenes.Count} pictures are right. {NextStep(rubric, marks)}".TrimEnd());
        page.Element("p", (marks.TeacherPoints is null ? "" : "Your teacher has decided: ")
            + $"{MarksTable.Number(marks.Points)} of {MarksTable.Number(rubric.Points)} points"
            + (marks.Undecided > 0 ? $"; {MarksTable.Number(marks.Undecided)} more are not decided: your teacher will look." : "."));
        if (marks.Comment != "") page.Element("p", marks.Comment);
        page.Table("Points", ["Part", "Points", "Why"], [.. marks.Items.Zip(rubric.Items, (item, of) => Row(rubric, item, of.Remark, marks))]);
        foreach (var note in marks.OnTests) page.Element("p", Sentence(note));
        page.Table("Other mistakes, which cost no points", ["What is to be seen"],
            [.. marks.Mistakes.Concat(marks.MissingParts).Except(marks.Items.SelectMany(item => item.Because))
                .Select(because => Hint(rubric, because, marks)).Where(hint => hint != "").Select(hint => $"<tr><td>{hint}</td></tr>")]);
        var common = pictures.All(picture => picture.Picture is null && picture.Problem == pictures[0].Problem) ? pictures[0].Problem : null;
        if (common is not null) page.Element("h2", "No pictures").Element("p", Sentence(pictures[0].ProblemOf(several: pictures.Count > 1)!));
        for (var i = 0; i < pictures.Count; i++) AddScene(page, marks.Scenes[i], pictures[i], common);
        return page.ToString();
    }

    /// <summary>The first thing to think about; empty if all is right, or if the rubric has no hints.</summary>
    private static string NextStep(Rubric rubric, StudentMarks marks) =>
        rubric.Hint == HintLevel.Question && marks.Items.Where(item => item is { Undecided: 0 }).SelectMany(item => item.Because)
            .Select(because => MarkWords.Question(because, marks.HidingMistakes)).FirstOrDefault(question => question != "") is { } question
            ? $"A next step: {question}" : "";

    private static string Row(Rubric rubric, ItemMarks item, string? remark, StudentMarks marks)
    {
        var style = item.Undecided > 0 ? "undecided" : item.Points < item.Of ? "lost" : "";
        var points = item.Undecided > 0 ? "not decided" : $"{MarksTable.Number(item.Points)} of {MarksTable.Number(item.Of)}";
        string[] why =
        [
            .. item.Undecided > 0 ? ["Not decided: your teacher will look."]
                : item.Because.Select(because => Hint(rubric, because, marks)).Where(hint => hint != ""),
            .. item.Tests is { } tests ? [$"{Page.Escaped(tests)}."] : (string[])[],
        ];
        return $"<tr class=\"{style}\"><td>{Page.Escaped(item.Name)}" +
            (remark is null ? "" : $"<br><span class=\"small\">{Page.Escaped(remark)}</span>") +
            $"</td><td class=\"n\">{points}</td><td>{string.Join("<br>", why)}</td></tr>";
    }

    /// <summary>A hint; empty for a mistake if the rubric has no hints.</summary>
    private static string Hint(Rubric rubric, string because, StudentMarks marks) => rubric.Hint switch
    {
        null => MistakeCatalog.Named(because) is null ? Page.Escaped(MarkWords.NotWritten(because)) : "",
        HintLevel.Symptom => Page.Escaped(MarkWords.Symptom(because, marks.Typical)),
        _ => Page.Escaped($"{MarkWords.Symptom(because, marks.Typical)} {MarkWords.Question(because, marks.HidingMistakes)}".Trim()),
    };

    private static string Sentence(string problem) => char.ToUpperInvariant(problem[0]) + problem[1..].TrimEnd('.') + ".";

    private static void AddScene(Page page, SceneMarks scene, SubmittedPicture submitted, string? common)
    {
        page.Element("h2",
            $"{scene.Name}: {(submitted.CanBeJudged || submitted.Picture is null ? scene.Verdict.InWords() : "another size")}");
        if (submitted.Problem is not null && submitted.Problem != common) page.Element("p", Sentence(submitted.ProblemOf()!));
        var mine = submitted.Picture is { } picture ? Page.Image(picture, $"your picture of {scene.Name}") : "";
        if (!submitted.CanBeJudged) page.Html($"<p>{mine}</p><p class=\"small\">The right picture:</p><p>{Right()}</p>");
        else if (scene.Verdict == SceneVerdict.Right) page.Html($"<p>{mine}</p>");
        else
        {
            var wrong = 100.0 * submitted.Scene.Diagnoser.WrongPixels(submitted.Picture!) / submitted.Picture!.Count;
            page.Element("p",
                FormattableString.Invariant($"{wrong:0.##} % of the pixels ") +
                $"differ by more than {PictureJudge.Tolerance} level. " +
                "Your picture is left of the line, the right picture right of it:", "small");
            page.Html($"""
                <div class="slid"><div class="pair">
                {mine}{Right()}</div>
                <input type="range" min="0" max="100" value="50" aria-label="how much is yours"
                    oninput="this.previousElementSibling.style.setProperty('--at', this.value + '%')"></div>
                """);
        }

        string Right() => Page.Image(submitted.Scene.Right, $"the right picture of {scene.Name}"); // not needed beside a right one
    }
}
