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
    public void HelpGroupsTheCommands()
    {
        raycaster.Run("help");
        Assert.Matches("(?s)For students:.*diagnose.*For teachers:.*handout.*mark.*vary.*check.*For large pictures and many:.*stitch",
            raycaster.OutputText);
    }
}
