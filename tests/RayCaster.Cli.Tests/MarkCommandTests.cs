namespace RayCaster.Cli.Tests;

/// <summary>Marks and varied scenes by the console app itself.</summary>
public sealed class MarkCommandTests : CommandTests
{
    private void WriteRubric(string more)
    {
        raycaster.Write("ball.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json"))
            .Replace("\"target\"", "\"width\": 60, \"height\": 40, \"target\""));
        raycaster.Write("rubric.json", $$"""
            { "title": "A ball", "scenes": ["ball.json"], {{more}} "items": [
                { "name": "ball", "points": 3, "mistakes": ["far-root", "oc-sign", "last-hit"], "undone": ["sphere"] },
                { "name": "floor", "points": 2, "mistakes": ["plane-sign"], "undone": ["plane"] } ] }
            """);
    }

    private string Folder(string student)
    {
        Directory.CreateDirectory(raycaster.PathOf(Path.Combine("class", student)));
        return $"class/{student}/";
    }

    private string[] Table() => File.ReadAllLines(raycaster.PathOf("marks/marks.csv"));

    [Fact]
    public void PicturesAreMarkedAndTheStudentsPageHoldsNoAnswer()
    {
        WriteRubric("");
        raycaster.Run("ball.json", "-q", "-o", Folder("anna") + "ball.png");
        raycaster.Write("empty.json", File.ReadAllText(raycaster.PathOf("ball.json"))
            .Replace("\"sphere\", \"center\": [0, 0, 1]", "\"sphere\", \"center\": [90, 0, 1]"));
        raycaster.Run("empty.json", "-q", "-o", Folder("=boris") + "ball.ppm");
        Folder("clara;=1+1");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");

        Assert.Equal(0, raycaster.ExitCode);
        Assert.Equal("student,points,undecided,of,teacher's points,comment,ball,floor,look yourself,not drawn yet,mistakes,right pictures",
            Table()[0]);
        Assert.Equal("'=boris,2,0,5,,,0,2,,sphere,,0 of 1", Table()[1]);
        Assert.Equal("anna,5,0,5,,,3,2,,,,1 of 1", Table()[2]);
        // a spreadsheet that separates cells by semicolons ran the name as a formula
        Assert.Equal("\"clara;=1+1\",0,5,5,,,0?,0?,ball: the student's folder is empty,,,0 of 1", Table()[3]);
        var page = File.ReadAllText(raycaster.PathOf("marks/=boris/feedback.html"));
        Assert.Contains("No spheres are drawn: they are not written yet, or a mistake hides them.", page);
        Assert.DoesNotContain("http", page); // it needs no network
        var forTheTeacher = File.ReadAllText(raycaster.PathOf("marks/class.html"));
        Assert.Contains("=boris", forTheTeacher);
        Assert.Contains("<h2>Most often: No spheres are drawn", forTheTeacher);
        Assert.Contains("2.33 of 5 points on average; 1.67 undecided. To look at yourself: 1.", forTheTeacher);
    }

    [Fact]
    public void FilesBesideTheSubmissionsAreTold()
    {
        WriteRubric("");
        Folder("clara");
        raycaster.Write("class/.DS_Store", "").Write("class/boris.zip", "").Write("class/dora.zip", "");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        Assert.Equal((0, $"a submission is a folder, so {Path.Combine("class", "boris.zip")} and 1 more are not marked\n"),
            (raycaster.ExitCode, raycaster.Error.ReplaceLineEndings("\n")));
    }

    [Fact]
    public void AFolderWithoutSubmissionsIsAnError()
    {
        WriteRubric("");
        Folder(".git");
        raycaster.Write("class/notes.txt", "");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal((2, "raycaster: no submissions in class: it contains no folders and 1 file, but must contain a folder for each student, " +
            "named after the student\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void WithoutHintsAMistakeHasNoWords()
    {
        WriteRubric("\"hint\": \"none\",");
        raycaster.Run("wrong", "ball.json", "far-root", "-q", "-o", Folder("anna") + "ball.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        Assert.Contains("<td>ball</td><td class=\"n\">0 of 3</td><td></td>", File.ReadAllText(raycaster.PathOf("marks/anna/feedback.html")));
    }

    [Fact(Skip = "has no such names", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ASubmissionsNameForgesNoRow()
    {
        WriteRubric("");
        Folder("anna\nboris,5");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal((2, "raycaster: the submission 'anna\uFFFDboris,5' has an invisible character in its name: rename it\n"),
            (raycaster.ExitCode, raycaster.Error));
        Assert.False(Directory.Exists(raycaster.PathOf("marks")));
    }

    [Fact]
    public void MarksInTheFolderOfSubmissionsAreRefused()
    {
        WriteRubric("");
        Folder("anna");
        raycaster.Run("mark", "rubric.json", "class", "-o", "class/marks", "-q");
        Assert.Equal((2, "raycaster: the marks cannot go to class/marks, which is in the folder of submissions: name a folder outside it\n"),
            (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void APictureOfAnotherSizeIsCalledThatAndStandsBesideTheRightOne()
    {
        WriteRubric("");
        raycaster.Run("ball.json", "-q", "-s", "20x20", "-o", Folder("anna") + "ball.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        var page = File.ReadAllText(raycaster.PathOf("marks/anna/feedback.html"));
        Assert.Contains("<h2>ball: another size</h2>\n<p>The picture is 20 x 20, not 60 x 40 pixels.</p>\n<p><img alt=\"your picture of ball\"",
            page);
        Assert.Contains("<img alt=\"the right picture of ball\"", page);
    }

    [Fact] // eighty mistakes that cost nothing were one line
    public void WhatIsSaidOfARubricFitsIntoATerminal()
    {
        WriteRubric("");
        raycaster.Run("mark", "rubric.json");
        Assert.Contains("These mistakes cost nothing: w-sign, ", raycaster.OutputText);
        Assert.All(raycaster.OutputText.Split('\n'), line => Assert.InRange(line.Length, 0, 100));
    }

    [Fact]
    public void ARubricWithAnErrorIsToldWithItsPlace()
    {
        WriteRubric("\"hnit\": \"none\",");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal(1, raycaster.ExitCode);
        Assert.StartsWith("rubric.json(1,47): error: hnit is an unknown key; did you mean \"hint\"?\n", raycaster.Error);
    }

    [Fact]
    public void AVariedSceneGoesToAFileOrToStandardOutput()
    {
        var scene = File.ReadAllText(ProjectFolder.PathOf("scenes/weeks/1-planes.json"))
            .Replace("\"width\": 300, \"height\": 200", "\"width\": 30, \"height\": 20");
        raycaster.Write("planes.json", scene).Run("vary", "planes.json", "--seed", "12345", "-o", "mine.json");
        var varied = File.ReadAllText(raycaster.PathOf("mine.json"));
        Assert.NotEqual(scene, varied);
        raycaster.Run("vary", "planes.json", "--seed", "12345", "-q", "-o", "-");
        Assert.Equal((0, varied), (raycaster.ExitCode, raycaster.OutputText));
    }

    [Fact]
    public void ASceneWithMeshesStaysWhereTheyAre()
    {
        raycaster.Run("vary", ProjectFolder.PathOf("scenes/mesh.json"), "--seed", "12345", "-o", "mine.json");
        Assert.Contains("names mesh files, whose paths start at its folder", raycaster.Error);
    }

    [Fact]
    public void HelpGroupsTheCommands()
    {
        raycaster.Run("help");
        Assert.Matches("(?s)For students:.*diagnose.*For teachers:.*handout.*mark.*vary.*check.*For large pictures and many:.*stitch",
            raycaster.OutputText);
    }
}
