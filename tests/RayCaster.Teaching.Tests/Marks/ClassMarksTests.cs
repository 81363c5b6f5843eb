namespace RayCaster.Teaching.Tests.Marks;

/// <summary>A class of pictures of one scene, and what is written about it.</summary>
public sealed class ClassMarksTests : InTemporaryFolder
{
    private readonly List<string> notices = [];
    private readonly Scene ball;

    public ClassMarksTests()
    {
        folder.Write("ball.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json"))
            .Replace("\"target\"", "\"width\": 60, \"height\": 40, \"target\""));
        ball = SceneReader.Read(folder["ball.json"]).Scene!;
        WriteRubric("");
    }

    private void WriteRubric(string more, string scenes = "\"ball.json\"") => folder.Write("rubric.json", $$"""
        { "title": "A ball", "scenes": [{{scenes}}], {{more}} "items": [
            { "name": "ball", "points": 3, "mistakes": ["far-root", "last-hit"], "undone": ["sphere"] },
            { "name": "floor", "points": 2, "undone": ["plane"] } ] }
        """);

    private string Place(string file)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(folder[file])!);
        return folder[file];
    }

    private ClassMarksTests Write(string file, string text)
    {
        File.WriteAllText(Place(file), text);
        return this;
    }

    private ClassMarksTests Draw(string file, string kindsLeftOut = "", string? mistake = null)
    {
        var scene = ball with { Models = [.. ball.Models.Where(model => model.Kind != kindsLeftOut)] };
        PictureFile.Write(Place(file), mistake is null ? ScalarRenderer.Render(scene)
            : MistakeCatalog.Draw(scene, [MistakeCatalog.Named(mistake)!.Usual]));
        return this;
    }

    /// <summary>Marks the class, and returns the rows of the table without its head.</summary>
    private string[] Mark(string submissions = "class", string output = "marks")
    {
        notices.Clear();
        var rubric = RubricReader.Read(folder["rubric.json"], out var report);
        Assert.Equal("", report);
        new ClassMarks(rubric!, folder[output], 2, null, text => { lock (notices) notices.Add(text); }).Mark(folder[submissions]);
        return File.ReadAllLines(folder[$"{output}/marks.csv"])[1..];
    }

    private string Refused(string submissions = "class", string output = "marks")
    {
        var problem = Assert.Throws<ProblemException>(() => Mark(submissions, output)).Message;
        Assert.False(Directory.Exists(folder[$"{output}/anna"])); // nothing was written
        return problem.Replace(folder.Path + Path.DirectorySeparatorChar, "");
    }

    [Fact]
    public void EachFolderIsARowWhateverIsInIt()
    {
        Draw("class/right/ball.png").Draw("class/unfinished/ball.png", "sphere").Write("class/text/ball.png", "a text")
            .Write("class/jpeg/ball.png", "\u00FF").Draw("class/upper/BALL.PNG").Write("class/packed/ball.rar", "")
            .Draw("class/deep/out/ball.png").Write("class/empty/notes", "");
        File.WriteAllBytes(folder["class/jpeg/ball.png"], [0xFF, 0xD8, 0xFF, 0xE0, .. "JFIF"u8]);
        Directory.CreateDirectory(folder["class/nothing"]);
        File.WriteAllBytes(Place("class/large/ball.png"), new byte[10_000_000]);
        PictureFile.Write(Place("class/small/ball.png"), new Picture(7, 5));
        var rows = Mark().ToDictionary(row => row.Split(',')[0]);
        Assert.StartsWith("right,5,0,5,,,3,2,,,,1 of 1", rows["right"]);
        Assert.StartsWith("unfinished,2,0,5,,,0,2,,sphere,,0 of 1", rows["unfinished"]);
        Assert.Contains("ball: the picture cannot be read", rows["text"]);
        Assert.Contains("it is a JPEG", rows["jpeg"]);
        Assert.Contains("the picture file has 10,000,000 bytes, too many for the scene's 2,400 pixels", rows["large"]);
        Assert.Contains("the picture is 7 x 5, not 60 x 40 pixels", rows["small"]);
        Assert.Contains("ball: no picture ball.png; there is ball.rar", rows["packed"]);
        Assert.Contains($"ball: no picture ball.png; there is {Path.Combine("out", "ball.png")}", rows["deep"]);
        Assert.Contains("ball: no picture ball.png,", rows["empty"]);
        Assert.Contains("ball: the student's folder is empty", rows["nothing"]);
        if (OperatingSystem.IsLinux()) Assert.Contains("ball: no picture ball.png; there is BALL.PNG", rows["upper"]);
        Assert.All(rows.Keys, student => Assert.True(File.Exists(folder[$"marks/{student}/feedback.html"])));
    }

    [Fact] // eight scenes were eight lines
    public void WhatIsMissingForOneReasonIsOneLine()
    {
        folder.Write("balls.json", File.ReadAllText(folder["ball.json"]));
        WriteRubric("", "\"ball.json\", \"balls.json\"");
        Draw("class/anna/out/ball.png").Draw("class/anna/out/balls.png").Draw("class/boris/ball.png");
        Assert.Contains($"all scenes: no picture SCENE.png; there are {Path.Combine("out", "ball.png")}, {Path.Combine("out", "balls.png")}",
            Mark()[0]);
    }

    [Theory(Skip = "no links without rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("class/anna/ball.png", "../boris/ball.png", "ball.png is a link")]
    [InlineData("class/anna", "boris", "the student's folder is a link")]
    public void ThePictureOfAnotherThatALinkLeadsToIsNotTaken(string link, string target, string problem)
    {
        Draw("class/boris/ball.png").Write("class/carla/notes", "");
        File.CreateSymbolicLink(Place(link), target);
        var rows = Mark();
        Assert.StartsWith("anna,0,5,5", rows[0]);
        Assert.Contains(problem, rows[0]);
        Assert.StartsWith("boris,5,0,5", rows[1]);
    }

    [Fact]
    public void TheTestsOfAStepCountBesideThePictures()
    {
        WriteRubric(""" "tests": "results*.xml", """);
        folder.Write("rubric.json", File.ReadAllText(folder["rubric.json"]).Replace("\"floor\",", "\"floor\", \"step\": 3,"));
        Draw("class/agree/ball.png").Write("class/agree/results1.xml", "<a><testcase classname='Step03' name='a'/></a>");
        Draw("class/contradict/ball.png")
            .Write("class/contradict/results1.xml", "<a><testcase classname='Step03' name='a'><failure/></testcase></a>");
        Draw("class/forged/ball.png").Write("class/forged/results1.xml", "<!DOCTYPE a []><a/>");
        Draw("class/none/ball.png");
        var rows = Mark();
        Assert.StartsWith("agree,5,0,5,,,3,2,,", rows[0]);
        Assert.StartsWith("contradict,3,2,5,,,3,0?,\"floor: 0 of 1 tests of step 3 pass, but its pictures cost no points\"", rows[1]);
        Assert.StartsWith("forged,5,0,5,,,3,2,the test results results1.xml cannot be read: ", rows[2]);
        Assert.StartsWith("none,5,0,5,,,3,2,,", rows[3]);
        Assert.Equal("1 of 4 submissions have no test results results*.xml: only their pictures count", Assert.Single(notices));
        Assert.Contains("1 of 1 tests of step 3 pass.", File.ReadAllText(folder["marks/agree/feedback.html"]));
    }

    [Theory]
    [InlineData("utf-8", ',')]
    [InlineData("utf-8 without a mark", ';')]
    [InlineData("utf-16", '\t')]
    [InlineData("windows-1252", ';')]
    public void WhatATeacherEntersIntoTheTableWinsAndIsKeptHoweverItIsSaved(string encoding, char separator)
    {
        Draw("class/anna/ball.png").Write("class/boris/notes", "").Mark();
        var table = File.ReadAllText(folder["marks/marks.csv"]).Replace("\uFEFF", "")
            .Replace("anna,5,0,5,,,", "anna,5,0,5,\"4,5\",„Schön“: 3 €,").Replace("boris,0,5,5,,,", "boris,0,5,5,,look again,");
        if (separator != ',') table = table.Replace(',', separator).Replace($"\"4{separator}5\"", "\"4,5\"");
        byte[] saved = encoding switch
        {
            "utf-8" => [.. Encoding.UTF8.Preamble, .. Encoding.UTF8.GetBytes(table)],
            "utf-16" => [.. Encoding.Unicode.Preamble, .. Encoding.Unicode.GetBytes(table)],
            "windows-1252" => [.. table.Select(c => c switch { '„' => (byte)0x84, '“' => (byte)0x93, '€' => (byte)0x80, _ => (byte)c })],
            _ => Encoding.UTF8.GetBytes(table),
        };
        File.WriteAllBytes(folder["marks/marks.csv"], saved);
        for (var run = 0; run < 2; run++)
        {
            var rows = Mark();
            Assert.StartsWith("anna,4.5,0,5,4.5,„Schön“: 3 €,3,2,", rows[0]);
            Assert.StartsWith("boris,0,5,5,,look again,0?,0?,", rows[1]);
            Assert.EndsWith("marks.csv: using your points or comments for anna, boris", Assert.Single(notices));
        }
        var page = File.ReadAllText(folder["marks/anna/feedback.html"]);
        Assert.Contains("<p>Your teacher has decided: 4.5 of 5 points.</p>\n<p>„Schön“: 3 €</p>", page);
    }

    [Theory]
    [InlineData("Zoe\u0308", "Zo\u00EB")]
    [InlineData("Zo\u00EB", "Zoe\u0308")]
    public void ARowFitsAFolderWhoseAccentsAreEncodedOtherwise(string folderName, string row)
    {
        Draw($"class/{folderName}/ball.png").Write("marks/marks.csv", $"student,teacher's points,comment\n{row},3,\n");
        Assert.StartsWith($"{folderName},3,0,5,3,", Mark()[0]);
    }

    [Theory]
    [InlineData("123", "row 2: 123; there is 00123: the spreadsheet took the name for a number. Format the column as text, then write 00123")]
    [InlineData("1,23457E+11", "row 2: 1,23457E+11; there is 123456789012: the spreadsheet took the name for a number.")]
    [InlineData("ana", "row 2: ana; the nearest: anna")]
    [InlineData("zoe", "row 2: zoe; no folder has a similar name")]
    public void ARowThatFitsNoFolderIsAnErrorBeforeAnythingIsWritten(string row, string problem)
    {
        Draw("class/anna/ball.png").Draw("class/00123/ball.png").Draw("class/123456789012/ball.png");
        Write("marks/marks.csv", $"student,teacher's points,comment\n\"{row}\",3,\n");
        Assert.StartsWith($"marks{Path.DirectorySeparatorChar}marks.csv: a row fits no folder, so nothing was written\n  {problem}",
            Refused().Replace('/', Path.DirectorySeparatorChar));
    }

    [Theory]
    [InlineData("student,teacher's points,comment\nanna,many,", "the teacher's points of anna must be a number, but is \"many\"")]
    [InlineData("student,teacher's points,comment\nanna,,\"oops\nboris,3,", "a cell begins with a quote (\") and does not end with one")]
    [InlineData("student,teacher's points,comment\nanna,3,\nanna,4,", "has two rows of anna that say different things: delete one of them")]
    [InlineData("name;points\nanna;3", "has no column \"student\", \"teacher's points\" or \"comment\"")]
    public void ATableThatCannotBeReadIsRefusedBeforeTheWork(string table, string problem)
    {
        Draw("class/anna/ball.png").Write("marks/marks.csv", table);
        Assert.Contains(problem, Refused());
    }

    [Theory]
    [InlineData("name;points\n\"Doe; Jane\";1,5", "name|points/Doe; Jane|1,5")]
    [InlineData("name,points\ra;b,2\r", "name|points/a;b|2")] // lines of an old Macintosh
    [InlineData("name\tpoints\r\n\r\n5\" disk\t\"2\"\"\"", "name|points//5\" disk|2\"")]
    public void ATableIsReadAsSpreadsheetsWriteIt(string text, string cells) => Assert.Equal(cells,
        string.Join('/', Csv.Read(folder.Write("table.csv", text)).Select(row => string.Join('|', row))).TrimEnd('/'));

    [Fact]
    public void APictureOfWhichAPartWasNotDrawnIsForTheTeacher()
    {
        var drawn = ScalarRenderer.Render(ball);
        PictureFile.Write(Place("class/anna/ball.png"), Picture.Create(drawn.Width, drawn.Height,
            (x, y) => y < 25 || y == 25 && x < 20 ? drawn[x, y] : ((byte)9, (byte)9, (byte)9)));
        var row = Assert.Single(Mark());
        Assert.StartsWith("anna,0,5,5,", row);
        Assert.Contains("ball: The last 14 lines are (9, 9, 9): does your loop reach them?", row);
    }

    [Theory]
    [InlineData("Anna", "anna", "by case")]
    [InlineData("Jose\u0301", "Jos\u00E9", "in how accents are encoded")]
    public void NamesThatSomeSystemsTakeForOneAreRefused(string one, string other, string way)
    {
        Draw($"class/{one}/ball.png").Draw($"class/{other}/ball.png");
        Assert.SkipWhen(Directory.GetDirectories(folder["class"]).Length == 1, "this system takes them for one");
        Assert.StartsWith($"the submissions '{one}' and '{other}' differ only {way}: ", Refused());
    }

    [Theory]
    [InlineData("class/anna", "anna holds pictures itself, so it seems to be one student's: is anna one folder too deep? Name the folder above it")]
    [InlineData("", "the only folder in ")] // class
    public void AFolderTooDeepOrTooHighIsToldAsSuch(string submissions, string problem)
    {
        Draw("class/anna/ball.png").Draw("class/boris/ball.png");
        Assert.Contains(problem, Refused(submissions));
    }

    [Fact]
    public void ThePageOfTheClassOpensAtTheMistakeThatMostMake()
    {
        Draw("class/anna/ball.png", mistake: "far-root").Draw("class/boris/ball.png", mistake: "far-root").Draw("class/carla/ball.png", "plane")
            .Draw("class/dora/ball.png").Mark();
        var page = File.ReadAllText(folder["marks/class.html"]);
        var first = page[page.IndexOf("</h1>")..page.IndexOf("<img")];
        Assert.Contains($"<h2>Most often: {Page.Escaped(MistakeCatalog.Named("far-root")!.Cause)}</h2>", first);
        Assert.Contains("2 of 4: ", first);
        Assert.Contains("\">anna</a>, <a href=\"boris/feedback.html\">boris</a>", first);
    }

    [Fact]
    public void StudentsWithTheSameWrongPictureAreNamedBesideEachOther()
    {
        Draw("class/anna/ball.png", mistake: "far-root").Draw("class/boris/ball.png", mistake: "far-root").Draw("class/carla/ball.png", "plane")
            .Draw("class/dora/ball.png").Draw("class/emil/ball.png").Mark();
        var page = File.ReadAllText(folder["marks/class.html"]);
        var same = page[page.IndexOf("The same wrong pictures")..];
        same = same[..same.IndexOf("</table>")];
        Assert.Contains("anna/feedback.html\">anna</a>, <a href=\"boris/feedback.html\">boris</a></td><td>ball</td>", same);
        Assert.DoesNotContain("carla", same);
        Assert.DoesNotContain("emil", same); // right pictures are the same, too
    }

    [Fact]
    public void WhatATeacherHasEnteredStaysThoughAPageCannotBeWritten()
    {
        Draw("class/anna/ball.png").Write("marks/anna/feedback.html/file", "")
            .Write("marks/marks.csv", "student,teacher's points,comment\nanna,3,good\n");
        Assert.StartsWith("anna,3,0,5,3,good,", Mark()[0]);
        Assert.Contains("it is a folder; name a file in it", notices[^1]);
    }
}
