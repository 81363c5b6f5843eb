namespace RayCaster.Teaching.Tests.Marks;

/// <summary>What the row, the pages and the summary of a class say of its test results.</summary>
public sealed class ClassTestResultsTests : InTemporaryFolder
{
    private const string Passes = "<a><testcase classname='Step03' name='a'/><testcase classname='Step08' name='b'/></a>";

    private readonly List<string> notices = [];

    public ClassTestResultsTests()
    {
        folder.Write("ball.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json"))
            .Replace("\"target\"", "\"width\": 60, \"height\": 40, \"target\""));
        WriteRubric("tests");
    }

    private void WriteRubric(string by, string title = "A ball") => folder.Write("rubric.json", $$"""
        { "title": "{{title}}", "scenes": ["ball.json"], "tests": "results*.xml", "items": [
            { "name": "floor", "points": 2, "step": 3, "by": "{{by}}", "undone": ["plane"] },
            { "name": "ball", "points": 3, "step": 8, "by": "{{by}}", "undone": ["sphere"] } ] }
        """);

    /// <summary>A student with the right picture and a file of test results.</summary>
    private ClassTestResultsTests Student(string name, string? results, string file = "results.xml")
    {
        Directory.CreateDirectory(folder[$"class/{name}"]);
        PictureFile.Write(folder[$"class/{name}/ball.png"], ScalarRenderer.Render(SceneReader.Read(folder["ball.json"]).Scene!));
        if (results is not null) File.WriteAllText(folder[$"class/{name}/{file}"], results);
        return this;
    }

    private string[] Mark(int toLookAt)
    {
        notices.Clear();
        var rubric = RubricReader.Read(folder["rubric.json"], out var report);
        Assert.Equal("", report);
        var count = new ClassMarks(rubric!, folder["marks"], 2, null, text => { lock (notices) notices.Add(text); }).Mark(folder["class"]);
        Assert.Equal(toLookAt, count.ToLookAt);
        Assert.Contains($"To look at yourself: {toLookAt}.", Page("class.html"));
        return File.ReadAllLines(folder["marks/marks.csv"])[1..];
    }

    private string Page(string file) => File.ReadAllText(folder[$"marks/{file}"]);

    [Theory]
    [InlineData("", "the test results results.xml cannot be read: it is empty: write JUnit, in the hand-out with dotnet test --logger ")]
    [InlineData("<test-run/>", "the test results results.xml cannot be read: it is NUnit's own format: write JUnit, with nunit3-console ")]
    [InlineData("<assemblies/>", "the test results results.xml cannot be read: it is xUnit's own format: write JUnit, with ")]
    [InlineData("<testsuite><testcase classname='Sphere' name='near'/></testsuite>",
        "the test results results.xml count for no step: JUnit must name it in a test's class or name, as in Step08Sphere")]
    [InlineData("<testsuite><testcase classname='Step08' name='near' status='notrun'/></testsuite>",
        "the test results have no test of step 3; 1 of 1 tests of step 8 did not run (notrun)")]
    [InlineData("<testsuite><testcase classname='Step07' name='near'/></testsuite>", "the test results have no test of step 3, 8")]
    [InlineData(null, "there are no test results results*.xml")]
    public void WhatDecidesNothingIsToldInTheRowAndOnBothPages(string? results, string note)
    {
        var row = Mark("", results);
        Assert.Contains(note, row.Replace("\"\"", "\""));
        Assert.StartsWith("anna,0,5,5,,,0?,0?,", row);
        var pages = new[] { "anna/feedback.html", "class.html" }.Select(page => Page(page).Replace("&quot;", "\"").Replace("&#x27;", "'"));
        Assert.All(pages, page => Assert.All(note.Split("; "), part => Assert.Contains(part[1..], page)));
        Assert.Contains("5 more are not decided", Page("anna/feedback.html"));
    }

    private string Mark(string _, string? results) => Student("anna", results).Mark(1)[0];

    [Fact]
    public void TheSummaryCountsTheStudentsWithoutResultsAndSaysWhatThatMeans()
    {
        Student("anna", Passes).Student("boris", null).Student("carla", "").Mark(2);
        Assert.Equal("1 of 3 submissions have no test results results*.xml: only their pictures count, and what tests alone decide is undecided",
            Assert.Single(notices));
    }

    [Theory]
    [InlineData("<testcase classname='Step08' name='b' status='notrun'/>", "1 of 2 tests of step 8 did not run (notrun)")]
    [InlineData("<testcase classname='Step08' name='b'><flakyFailure/></testcase>",
        "\"flaky tests of step 8, whose last attempt counts: b\"")]
    public void WhatIsOddBesideAResultIsTold(string more, string note)
    {
        var row = Student("anna", $"<a>{"<testcase classname='Step03' name='a'/><testcase classname='Step08' name='c'/>"}{more}</a>").Mark(1)[0];
        Assert.Equal($"anna,5,0,5,,,2,3,{note},,,1 of 1", row);
        Assert.Contains($"<p>{char.ToUpper(note.Trim('"')[0])}{note.Trim('"')[1..]}.</p>", Page("anna/feedback.html"));
    }

    [Fact]
    public void EachFileThatCannotBeReadIsToldBesideTheOthers()
    {
        var row = Student("anna", Passes, "results1.xml").Student("anna", "", "results2.xml").Student("anna", "log", "results3.xml").Mark(1)[0];
        Assert.StartsWith("anna,5,0,5,,,2,3,", row);
        Assert.Contains("the test results results2.xml cannot be read: it is empty", row);
        Assert.Contains("the test results results3.xml cannot be read: it is no XML", row);
    }

    [Fact(Skip = "no links without rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ResultsBehindALinkAreNotReadAndToldAsSuch()
    {
        Student("anna", Passes).Student("boris", null);
        File.CreateSymbolicLink(folder["class/boris/results.xml"], "../anna/results.xml");
        Assert.StartsWith("boris,0,5,5,,,0?,0?,\"the test results results.xml cannot be read: a link leads to it, ", Mark(1)[1]);
    }

    [Fact] // names of tests come from a stranger's file
    public void NoControlCharacterGetsIntoTheTable()
    {
        Student("anna", "<a><testcase classname='Step08' name='&#x1B;[31mb\u001b&#7;\u009b' status='&#x1B;off'/></a>");
        if (!Here.IsWindows) File.WriteAllText(folder["class/anna/a\u001b\u0007.png"], "");
        File.Delete(folder["class/anna/ball.png"]);
        Mark(1);
        Assert.DoesNotContain(Page("marks.csv"), c => char.IsControl(c) && c is not ('\r' or '\n'));
    }

    [Fact] // the expected text is written out here, not computed by what makes the pages
    public void NoNameCommentOrFileNameBecomesHtml()
    {
        const string script = "<script>alert(1)</script>";
        WriteRubric("tests", script);
        var name = Here.IsWindows ? "&lt;b&gt;'onload=x" : "<script>alert(1)<\u2215script>'\"&amp;";
        Student(name, $"<a><testcase classname='Step08' name='&lt;script&gt;x&lt;/script&gt;' status='&lt;script&gt;'/></a>");
        if (!Here.IsWindows) File.Move(folder[$"class/{name}/ball.png"], folder[$"class/{name}/<script>.png"]);
        Directory.CreateDirectory(folder["marks"]);
        File.WriteAllText(folder["marks/marks.csv"], $"student,teacher's points,comment\n\"{name.Replace("\"", "\"\"")}\",1,{script}\n");
        Mark(1);
        foreach (var page in new[] { $"{name}/feedback.html", "class.html" }.Select(Page))
        {
            Assert.DoesNotContain("<script", page);
            Assert.DoesNotContain("onload=x'", page);
            Assert.Contains("&lt;script&gt;alert(1)&lt;/script&gt;", page); // the title
        }
        Assert.Contains("<p>&lt;script&gt;alert(1)&lt;/script&gt;</p>", Page($"{name}/feedback.html")); // the comment
        Assert.Contains("did not run (&lt;script&gt;)", Page("class.html"));
        if (Here.IsWindows) return;
        Assert.Contains("No picture ball.png; there is &lt;script&gt;.png.", Page($"{name}/feedback.html"));
        Assert.Contains("<h1>&lt;script&gt;alert(1)&lt;/script&gt;: &lt;script&gt;alert(1)&lt;∕script&gt;&#x27;&quot;&amp;amp;</h1>",
            Page($"{name}/feedback.html"));
        Assert.Contains("<a href=\"%3Cscript%3Ealert%281%29%3C%E2%88%95script%3E%27%22%26amp%3B/feedback.html\">&lt;script&gt;alert(1)",
            Page("class.html"));
    }

    [Fact]
    public void TheSentenceOfOneMissingPictureNamesItsFileAndThatOfSeveralSaysScene()
    {
        folder.Write("balls.json", File.ReadAllText(folder["ball.json"]));
        folder.Write("rubric.json", File.ReadAllText(folder["rubric.json"]).Replace("\"ball.json\"", "\"ball.json\", \"balls.json\"")
            .Replace("\"title\"", "\"pictures\": \"out/{name}.png\", \"title\""));
        Student("anna", Passes).Student("boris", Passes);
        Directory.CreateDirectory(folder["class/anna/out"]);
        File.Move(folder["class/anna/ball.png"], folder["class/anna/out/ball.png"]);
        var rows = Mark(2);
        Assert.EndsWith(",balls: no picture out/balls.png,,,1 of 2", rows[0]);
        Assert.EndsWith("all scenes: no picture out/SCENE.png; there is ball.png,,,0 of 2", rows[1].Replace("\"", ""));
        Assert.Contains("<h2>balls: no picture</h2>\n<p>No picture out/balls.png.</p>", Page("anna/feedback.html"));
    }
}
