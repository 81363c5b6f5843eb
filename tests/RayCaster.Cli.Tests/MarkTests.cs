namespace RayCaster.Cli.Tests;

/// <summary>Marks and varied scenes by the console app itself.</summary>
public sealed class MarkTests : CommandTests
{
    private void WriteRubric(string more)
    {
        raycaster.Write("ball.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json"))
            .Replace("\"target\"", "\"width\": 60, \"height\": 40, \"target\""));
        if (more.Contains("\"run\"")) more += $" \"readable\": [\"{Path.GetDirectoryName(RayCasterProcess.App)}\"],";
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
        Assert.Equal("\"clara;=1+1\",0,5,5,,,0?,0?,ball: the submission's folder is empty,,,0 of 1", Table()[3]);
        var page = File.ReadAllText(raycaster.PathOf("marks/=boris/feedback.html"));
        Assert.Contains("No spheres are drawn: they are not written yet, or a mistake hides them.", page);
        Assert.DoesNotContain("http", page); // it needs no network
        var forTheTeacher = File.ReadAllText(raycaster.PathOf("marks/class.html"));
        Assert.Contains("=boris", forTheTeacher);
        Assert.Contains("To discuss next: No spheres are drawn.", forTheTeacher);
        Assert.Contains("2.33 of 5 points on average; 1.67 undecided. To look at yourself: 1.", forTheTeacher);
    }

    [Fact]
    public void RowsAndPagesAreNamedByIds()
    {
        WriteRubric("");
        Folder("Anna Lee");
        Folder("boris");
        raycaster.Write("ids.csv", "folder;id;e-mail\nAnna Lee;s123;a@b.c\n");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q", "--ids", "ids.csv");
        Assert.Equal(["boris", "s123"], Table().Skip(1).Select(row => row.Split(',')[0]).Order());
        Assert.Contains("<h1>A ball: s123</h1>", File.ReadAllText(raycaster.PathOf("marks/s123/feedback.html")));
        raycaster.Write("ids.csv", "Anna Lee,s1\nboris,s1\n").Run("mark", "rubric.json", "class", "-o", "marks", "--ids", "ids.csv");
        Assert.Equal((2, "raycaster: ids.csv has the id s1 twice\n"), (raycaster.ExitCode, raycaster.Error));
        raycaster.Write("ids.csv", "boris,Anna Lee\n").Run("mark", "rubric.json", "class", "-o", "marks", "--ids", "ids.csv");
        Assert.Equal("raycaster: the id 'Anna Lee' is also the name of another submission: choose another one\n", raycaster.Error);
        raycaster.Write("ids.csv", "s123;Anna Lee\n").Run("mark", "rubric.json", "class", "-o", "marks", "--ids", "ids.csv");
        Assert.StartsWith("raycaster: ids.csv has an id for none of the submissions: ", raycaster.Error);
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
        raycaster.Write("class/ball.png", "");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal((2, "raycaster: no submissions in class: it contains no folders and 1 file, but must contain a folder for each student, " +
            "named after the student\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [SkippableFact]
    public void AProgramThatDoesNotBuildIsToldOnceWithItsErrors()
    {
        Skip.If(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        WriteRubric("""  "build": ["sh", "{dir}/build.sh"], "run": ["draw", "{scene}", "{out}"], """);
        var folder = raycaster.PathOf("class/anna");
        var error = $"{folder}/Sphere.cs(3,5): error CS1002: ; expected [{folder}/Lab.csproj]";
        raycaster.Write(Folder("anna") + "build.sh", $"echo '{error}'; echo Build FAILED.; echo '{error}'; echo '    1 Error(s)'; exit 1");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        const string problem = "t does not build: ended with exit code 1; it printed: Sphere.cs(3,5): error CS1002: ; expected";
        Assert.Contains($"\"ball: i{problem}\",", Table()[1]);
        Assert.Equal(2, File.ReadAllText(raycaster.PathOf("marks/anna/feedback.html")).Split($"I{problem}.").Length);
    }

    [Fact]
    public void WithoutHintsAMistakeHasNoWords()
    {
        WriteRubric("\"hint\": \"none\",");
        raycaster.Run("wrong", "ball.json", "far-root", "-q", "-o", Folder("anna") + "ball.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        Assert.Contains("<td>ball</td><td class=\"n\">0 of 3</td><td></td>", File.ReadAllText(raycaster.PathOf("marks/anna/feedback.html")));
    }

    [SkippableFact]
    public void HostileProgramsAreRows()
    {
        Skip.If(OperatingSystem.IsWindows(), "the programs are scripts of a POSIX shell");
        WriteRubric("""  "run": ["sh", "{dir}/draw.sh", "{scene}", "{out}"], "outputLimit": 1, """);
        void Write(string student, string script) => raycaster.Write(Folder(student) + "draw.sh", script);
        Write("crashes", "kill -SEGV $$");
        Write("error", "printf 'error\\t%07000d' 1; exit 1");
        Write("jpeg", @"printf '\377\330\377\340JFIF' > ""$2""");
        Write("link", "ln -s /dev/zero \"$2\"");
        Write("nothing", "echo I cannot");
        Write("other", "echo P3 1 1 1 0 0 0 > room.ppm");
        Write("pipe", "mkfifo \"$2\"");
        Write("prints", "while :; do echo aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa; done");
        Write("right", $"'{RayCasterProcess.App}' \"$1\" -q -o \"$2\"");
        Write("size", $"'{RayCasterProcess.App}' \"$1\" -q -s 7x5 -o \"$2\"");
        Write("{out} {name}", $"'{RayCasterProcess.App}' \"$1\" -q -o \"$2\"");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q", "-t", "2");

        Assert.Equal(("", 0), (raycaster.Error, raycaster.ExitCode));
        string[] rows = Table();
        Assert.Equal(12, rows.Length);
        Assert.Contains("crashed", rows[1]);
        Assert.Contains($"it printed: error\t{new string('0', 394)} …\",", rows[2]); // a long error is quoted in part
        Assert.Contains("it is a JPEG", rows[3]);
        Assert.Contains("a link to another file", rows[4]);
        Assert.Contains("it wrote no picture; it printed: I cannot", rows[5]);
        Assert.Contains("ball: it wrote room.ppm, not the picture that it was told", rows[6]);
        Assert.Contains("the picture file is empty", rows[7]);
        Assert.Contains("printed more than 1 MB", rows[8]);
        Assert.Contains("right,5,0,5", rows[9]);
        Assert.Contains("the picture is 7 x 5, not 60 x 40 pixels", rows[10]);
        Assert.Contains("{out} {name},5,0,5", rows[11]); // named like a place in the command
    }

    [Fact] // the pictures of other scenes do not help
    public void WhereAPictureIsMissingPicturesOfOtherNamesAreTold()
    {
        WriteRubric("");
        raycaster.Write("balls.json", File.ReadAllText(raycaster.PathOf("ball.json")));
        var rubric = File.ReadAllText(raycaster.PathOf("rubric.json"));
        raycaster.Write("rubric.json", rubric.Replace("[\"ball.json\"]", "[\"ball.json\", \"balls.json\"]"));
        raycaster.Run("ball.json", "-q", "-o", Folder("anna") + "ball.png");
        raycaster.Run("ball.json", "-q", "-o", Folder("anna") + "b a l l s.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Contains("balls: no picture balls.png; there is b a l l s.png,", Table()[1].Replace("\"", ""));
    }

    [SkippableFact]
    public void AProgramThatHangsIsOutOfTime()
    {
        Skip.If(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        WriteRubric("""  "run": ["sh", "{dir}/draw.sh", "{scene}", "{out}"], "timeLimit": 1, """);
        raycaster.Write(Folder("hangs") + "draw.sh", "sleep 100");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        Assert.Contains("out of time after 1 s", Table()[1]);
    }

    [Fact]
    public void ANameThatIsTooLongForTheFilesOfTheMarksIsRefused()
    {
        WriteRubric("");
        Folder(new('ä', 125));
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.EndsWith("has a name of 250 bytes, the limit is 200: rename it\n", raycaster.Error);
    }

    [SkippableFact]
    public void AMissingFolderForTemporaryFilesIsTold()
    {
        Skip.If(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        WriteRubric("""  "run": ["sh", "{dir}/draw.sh", "{scene}", "{out}"], """);
        raycaster.Write(Folder("anna") + "draw.sh", "exit 1").RunInShell("TMPDIR=/no/such raycaster mark rubric.json class -o marks -q");
        Assert.Equal((2, "raycaster: there is no folder for temporary files, /no/such/: make it, or let TMPDIR name another one\n"),
            (raycaster.ExitCode, raycaster.Error));
    }

    [SkippableFact]
    public void AProgramThatDeletesTheClassAndItsMarksIsARow()
    {
        Skip.If(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        WriteRubric("""  "run": ["sh", "{dir}/draw.sh", "{scene}", "{out}"], """);
        raycaster.Write(Folder("vandal") + "draw.sh",
            $"rm -rf '{raycaster.PathOf("class")}' '{raycaster.PathOf("marks")}' '{raycaster.PathOf("rubric.json")}' 2>/dev/null");
        raycaster.Write(Folder("victim") + "draw.sh", $"'{RayCasterProcess.App}' \"$1\" -q -o \"$2\"");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q", "-t", "1");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.StartsWith("vandal,0,5,5", Table()[1]);
        Assert.Equal("victim,5,0,5,,,3,2,,,,1 of 1", Table()[2]);
    }

    [Fact]
    public void MarksThatCannotBeWrittenAreToldInWords()
    {
        WriteRubric("");
        Folder("anna");
        Directory.CreateDirectory(raycaster.PathOf("marks/anna/feedback.html"));
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        var problem = $"cannot write {Path.Combine("marks", "anna", "feedback.html")}: it is a folder; name a file in it";
        Assert.Equal((0, $"anna: {problem}\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal($"anna,0,5,5,,,0?,0?,\"ball: not marked: {problem}\",,,0 of 1", Table()[1]);
    }

    [SkippableFact]
    public void ASubmissionsNameForgesNoRow()
    {
        Skip.If(OperatingSystem.IsWindows(), "has no such names");
        WriteRubric("");
        Folder("anna\nboris,5");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal((2, "raycaster: the submission 'anna\uFFFDboris,5' has an invisible character in its name: rename it\n"),
            (raycaster.ExitCode, raycaster.Error));
        Assert.False(Directory.Exists(raycaster.PathOf("marks")));
    }

    [Theory]
    [InlineData("Class.html", "marks", "the submission 'Class.html' is named like a file of the marks: rename the folder")]
    [InlineData("anna", "class/marks", "the marks cannot go to class/marks, which is in the folder of submissions: name a folder outside it")]
    public void PlacesThatMarksAndSubmissionsShareAreRefusedBeforeAnyProgramRuns(string student, string output, string problem)
    {
        WriteRubric("""  "run": ["touch", "{dir}/ran", "{scene}", "{out}"], """);
        var folder = Folder(student);
        raycaster.Run("mark", "rubric.json", "class", "-o", output, "-q");
        Assert.Equal((2, $"raycaster: {problem}\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.False(File.Exists(raycaster.PathOf(folder + "ran")));
    }

    [Fact]
    public void WithResumeOnlyWhatHasChangedIsMarkedAnew()
    {
        WriteRubric("");
        raycaster.Run("ball.json", "-q", "-o", Folder("anna") + "ball.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        var page = raycaster.PathOf("marks/anna/feedback.html");
        var before = new DateTime(2020, 1, 1);
        File.SetLastWriteTimeUtc(page, before);
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "--resume");
        Assert.Equal(before, File.GetLastWriteTimeUtc(page));
        raycaster.Write("class/anna/note.txt", "changed");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "--resume");
        Assert.NotEqual(before, File.GetLastWriteTimeUtc(page));
    }

    [Fact]
    public void WithResumeAChangedMeshIsMarkedAnew()
    {
        raycaster.Write("tent.obj", "v 0 -1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        raycaster.Write("tent.json", """
            { "camera": { "position": [5, 0, 0.5], "target": [0, 0, 0.5], "width": 60, "height": 40 },
              "models": [{ "type": "mesh", "file": "tent.obj" }] }
            """);
        raycaster.Write("rubric.json",
            """{ "scenes": ["tent.json"], "items": [{ "name": "tent", "points": 1, "undone": ["mesh"] }] }""");
        raycaster.Run("tent.json", "-q", "-o", Folder("anna") + "tent.png");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q");
        Assert.StartsWith("anna,1,0,1", Table()[1]);
        raycaster.Write("tent.obj", "v 0 -1 0\nv 0 1 0\nv 0 0 2\nf 1 2 3\n");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks", "-q", "--resume");
        Assert.EndsWith("0 of 1", Table()[1]);
    }

    [SkippableFact]
    public void AnInterruptedRunSaysHowToContinue()
    {
        Skip.If(OperatingSystem.IsWindows(), "no kill command there");
        WriteRubric("\"run\": [\"sh\", \"{dir}/draw.sh\", \"{scene}\", \"{out}\"],");
        raycaster.Write(Folder("anna") + "draw.sh", "exit 1");
        raycaster.Write(Folder("boris") + "draw.sh", "sleep 100");
        using var process = raycaster.Start("mark", "rubric.json", "class", "-o", "marks", "-t", "1", "-q");
        while (!File.Exists(raycaster.PathOf("marks/.kept/anna.json")) && !process.HasExited) Thread.Sleep(10);
        Assert.Equal(130, RayCasterProcess.Kill(process, "INT"));
        Assert.EndsWith("; --resume continues\n", process.StandardError.ReadToEnd());
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
        WriteRubric("\"tiemLimit\": 3,");
        raycaster.Run("mark", "rubric.json", "class", "-o", "marks");
        Assert.Equal(1, raycaster.ExitCode);
        Assert.StartsWith("rubric.json(1,47): error: tiemLimit is an unknown key; did you mean \"timeLimit\"?\n", raycaster.Error);
    }

    [Fact]
    public void ASceneIsVariedAndItsMeshesStayWhereTheyAre()
    {
        var scene = SmallScene();
        raycaster.Run("vary", "planes.json", "--seed", "12345", "-o", "mine.json");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.NotEqual(scene, File.ReadAllText(raycaster.PathOf("mine.json")));
        raycaster.Run("vary", ProjectFolder.PathOf("scenes/mesh.json"), "--seed", "12345", "-o", "mine.json");
        Assert.Contains("names mesh files, whose paths start at its folder", raycaster.Error);
    }

    [Fact]
    public void AVariedSceneGoesToStandardOutputWhenAsked()
    {
        SmallScene();
        raycaster.Run("vary", "planes.json", "--seed", "12345", "-o", "mine.json");
        raycaster.Run("vary", "planes.json", "--seed", "12345", "-q", "-o", "-");
        Assert.Equal(File.ReadAllText(raycaster.PathOf("mine.json")), raycaster.OutputText);
        Assert.Equal(["mine.json", "planes.json"], raycaster.Files);
    }

    /// <summary>Writes planes.json, a scene of the course with a smaller picture.</summary>
    private string SmallScene()
    {
        var text = File.ReadAllText(ProjectFolder.PathOf("scenes/weeks/1-planes.json"))
            .Replace("\"width\": 300, \"height\": 200", "\"width\": 75, \"height\": 50");
        Assert.Contains("75", text);
        raycaster.Write("planes.json", text);
        return text;
    }

    [Fact]
    public void HelpGroupsTheCommands()
    {
        raycaster.Run("help");
        Assert.Matches("(?s)For students:.*diagnose.*For teachers:.*handout.*mark.*vary.*check.*For large pictures and many:.*stitch",
            raycaster.OutputText);
    }
}
