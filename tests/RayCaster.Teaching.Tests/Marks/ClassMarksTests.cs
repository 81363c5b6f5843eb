namespace RayCaster.Teaching.Tests.Marks;

/// <summary>Students' programs that attack the marks, others' submissions or the teacher's files, as scripts of a POSIX shell.</summary>
public sealed class ClassMarksTests : IDisposable
{
    private const string Draw = """ "run": ["sh", "{dir}/draw.sh", "{scene}", "{out}"], "readable": ["shown"], """;

    private readonly TemporaryFolder folder = new();
    private readonly List<string> notices = [];

    /// <summary>The key of the marks is in a folder for temporary files.</summary>
    static ClassMarksTests() => Environment.SetEnvironmentVariable("XDG_DATA_HOME", Path.Combine(Path.GetTempPath(), "raycaster-tests"));

    public ClassMarksTests() => WriteRubric(Draw);

    public void Dispose() => folder.Dispose();

    private void WriteRubric(string more)
    {
        folder.Write("rubric.json", $$"""
            { "scenes": ["lab/ball.json"], {{more}} "items": [
                { "name": "ball", "points": 3, "mistakes": ["far-root"], "undone": ["sphere"] },
                { "name": "floor", "points": 2, "undone": ["plane"] } ] }
            """);
        WriteFile("lab/ball.json", File.ReadAllText(ProjectFolder.PathOf("scenes/first.json"))
            .Replace("\"target\"", "\"width\": 60, \"height\": 40, \"target\""));
        PictureFile.Write(WriteFile("shown/right.png", ""), ScalarRenderer.Render(SceneReader.Read(folder["lab/ball.json"]).Scene!));
    }

    private string WriteFile(string file, string text)
    {
        Directory.CreateDirectory(Path.GetDirectoryName(folder[file])!);
        return folder.Write(file, text);
    }

    /// <summary>A program that draws the right picture.</summary>
    private string RightProgram => $"cp '{folder["shown/right.png"]}' \"$2\"";

    private ClassMarksTests Write(string student, string script, string file = "draw.sh")
    {
        WriteFile($"class/{student}/{file}", script);
        return this;
    }

    private StudentMarks[] Mark(Containment? containment = null, bool resume = false, int threads = 1)
    {
        notices.Clear();
        var options = new ClassMarks.Options(threads, resume, null, text => { lock (notices) notices.Add(text); }) { Containment = containment };
        return [.. ClassMarks.Mark(RubricReader.Read(folder["rubric.json"], out _)!, folder["class"], folder["marks"], options, default)];
    }

    private static string PointsOf(IEnumerable<StudentMarks> marks) =>
        string.Join(", ", marks.Select(student => FormattableString.Invariant($"{student.Student} {student.Points}")));

    [Theory]
    [InlineData(".kept/anna.json", "\"points\":0", "\"points\":3")] // the points that a friend writes
    [InlineData("anna/feedback.html", "not decided</td>", "3 of 3</td>")] // and the page to it
    public void ForgedMarksAreNotKept(string file, string old, string forged)
    {
        Write("anna", "exit 1").Mark();
        var text = File.ReadAllText(folder["marks/" + file]);
        Assert.Contains(old, text);
        folder.Write("marks/" + file, text.Replace(old, forged));
        Assert.Equal("anna 0", PointsOf(Mark(resume: true)));
        Assert.DoesNotContain(forged, File.ReadAllText(folder["marks/" + file]));
    }

    [Fact]
    public void WhatATeacherEntersIntoTheTableWinsAndIsKept()
    {
        Write("anna", "exit 1").Write("boris", "exit 1").Mark();
        var table = File.ReadAllText(folder["marks/marks.csv"]);
        var saved = table.Replace("anna,0,5,5,,,", "anna,0,5,5,\"4,5\",Schön; fast,").Replace("boris,0,5,5,,,", "boris,0,5,5,,look again,")
            + "carla,3,,5,3,by mail\r\n"; // who has handed in otherwise
        File.WriteAllBytes(folder["marks/marks.csv"], System.Text.Encoding.Latin1.GetBytes(saved.TrimStart('\uFEFF')));
        for (var run = 0; run < 2; run++)
        {
            Assert.Equal("anna 4.5, boris 0", PointsOf(Mark(resume: true)));
            var rows = File.ReadAllLines(folder["marks/marks.csv"]);
            Assert.StartsWith("anna,4.5,0,5,4.5,\"Schön; fast\",0?,0?,", rows[1]);
            Assert.StartsWith("boris,0,5,5,,look again,0?,0?,", rows[2]);
            Assert.Equal("carla,3,,5,3,by mail", rows[3]);
            Assert.EndsWith("marks.csv: taken from you are the points or comments of anna, boris, carla", Assert.Single(notices));
        }
        var page = File.ReadAllText(folder["marks/anna/feedback.html"]);
        Assert.Contains("<p>Your teacher has decided: 4.5 of 5 points.</p>\n<p>Schön; fast</p>", page);
    }

    [Fact]
    public void AnArchiveOfFoldersAndArchivesIsUnpackedAndMarked()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the programs are scripts of a POSIX shell");
        Write("anna", RightProgram).Write("boris", RightProgram).Write("carla", RightProgram);
        Zip("class/boris"); // an archive beside the folders, and one in a folder
        Zip("class/carla");
        Directory.CreateDirectory(folder["class/carla"]);
        File.Move(folder["class/carla.zip"], folder["class/carla/lab.zip"]);
        WriteFile("class/damaged.zip", "PK and no more");
        Zip("class");
        var marks = ClassMarks.Mark(RubricReader.Read(folder["rubric.json"], out _)!, folder["class.zip"], folder["marks"], new(1), default);
        Assert.Equal("anna 5, boris 5, carla 5, damaged 0", PointsOf(marks));
        Assert.Contains("\r\nanna,5,\r\n", File.ReadAllText(folder["marks/moodle.csv"]));
        Assert.Contains("\r\nanna,,anna,,,5\r\n", File.ReadAllText(folder["marks/canvas.csv"]));
    }

    private void Zip(string path)
    {
        System.IO.Compression.ZipFile.CreateFromDirectory(folder[path], folder[path + ".zip"]);
        Directory.Delete(folder[path], recursive: true);
    }

    [Theory]
    [InlineData("anna/.zip", "anna/lab/main.c")] // .zip would be unpacked into the student's folder
    [InlineData(".zip", "anna/lab/main.c")]
    [InlineData("anna/lab.zip", "anna/lab/main.c")]
    [InlineData("anna.zip", "anna/lab/main.c")]
    [InlineData("anna.zip", "anna")]
    public void AnArchiveNeverTakesThePlaceOfAFileOrFolder(string archive, string file)
    {
        WriteFile("class/" + file, "main");
        WriteFile("class/" + archive, "PK and no more");
        Zip("class");
        Archive.Unpack(folder["class.zip"], notices.Add, default);
        Assert.Equal("main", File.ReadAllText(folder["class/" + file]));
        Assert.EndsWith("exists already", Assert.Single(notices));
    }

    [Fact]
    public void AnArchiveAloneInAFolderReplacesItWhateverTheOthersAreCalled()
    {
        WriteFile("own/lab/main.c", "");
        WriteFile("own/notes", "");
        Zip("own");
        WriteFile("class/anna.unpacked/main.c", "");
        WriteFile("class/__MACOSX/anna/._lab.zip", "");
        File.Move(folder["own.zip"], WriteFile("class/anna/lab.zip", ""), true);
        Zip("class");
        Archive.Unpack(folder["class.zip"], null, default);
        Assert.Equal(["anna.unpacked/main.c", "anna/lab/main.c", "anna/notes"],
            Directory.EnumerateFiles(folder["class"], "*", SearchOption.AllDirectories)
                .Select(path => Path.GetRelativePath(folder["class"], path).Replace('\\', '/')).Order(StringComparer.Ordinal));
    }

    [Fact]
    public void AFolderAroundEverythingIsLeftOut()
    {
        WriteFile("class/class/anna/lab1/lab1/main.c", "");
        Zip("class/class/anna");
        Zip("class");
        Archive.Unpack(folder["class.zip"], null, default);
        Assert.True(File.Exists(folder["class/anna/lab1/main.c"]));
    }

    [Fact]
    public void MarksThatCannotBeWrittenAreRefusedBeforeAnyProgramRuns()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the programs are scripts of a POSIX shell");
        Write("anna", $"touch '{folder["trace"]}'");
        var rubric = RubricReader.Read(folder["rubric.json"], out _)!;
        var problem = Assert.Throws<ProblemException>(() => ClassMarks.Mark(
            rubric, folder["class"], folder["rubric.json/marks"], new(1) { Containment = Containment.None }, default));
        Assert.StartsWith($"cannot write {folder["rubric.json/marks"]}", problem.Message);
        Assert.False(File.Exists(folder["trace"]));
    }

    [Fact]
    public void UnpackingThatIsInterruptedLeavesNoFolder()
    {
        WriteFile("class/anna/main.c", "main");
        Zip("class");
        Assert.Throws<OperationCanceledException>(() => Archive.Unpack(folder["class.zip"], null, new(canceled: true)));
        Assert.False(Path.Exists(folder["class"]));
    }

    [Theory]
    [InlineData("\"Doe, Jane\";17", "[Doe, Jane, 17]")]
    [InlineData("\"a;b\",1\rc,2\r", "[a;b, 1] [c, 2]")] // lines of an old Macintosh
    [InlineData("'t Hooft,'=1", "['t Hooft, =1]")]
    [InlineData("5\" disk,1\nc,\"2\"\"\"", "[5\" disk, 1] [c, 2\"]")]
    public void ATableThatASpreadsheetOrAHandHasWrittenIsRead(string text, string ids) =>
        Assert.Equal(ids, string.Join(' ', TeacherTable.Ids(WriteFile("ids.csv", text)).Select(id => id.ToString())));

    [Fact]
    public void WhatATeacherHasEnteredStaysThoughAPageCannotBeWritten()
    {
        WriteFile("class/anna/main.c", "");
        WriteFile("marks/marks.csv", "student,teacher's points,comment\nanna,3,good\n");
        WriteFile("marks/anna/feedback.html/file", "");
        Assert.Equal("anna 3", PointsOf(Mark()));
        Assert.Contains("\r\nanna,3,0,5,3,good,", File.ReadAllText(folder["marks/marks.csv"]));
    }

    [Theory]
    [InlineData("../evil", 0, "leads out of it")]
    [InlineData("/tmp/evil", 0, "leads out of it")]
    [InlineData("anna/link", 0xA000, "is a link")]
    [InlineData("anna/large", 0, "too many bytes")]
    [InlineData("anna/secret", 0, "is encrypted")]
    public void AnArchiveThatAttacksIsNotUnpacked(string entry, int type, string problem)
    {
        using (var archive = System.IO.Compression.ZipFile.Open(folder["class.zip"], System.IO.Compression.ZipArchiveMode.Create))
        {
            archive.CreateEntry("anna/good");
            var one = archive.CreateEntry(entry);
            one.ExternalAttributes = type << 16;
            using var stream = one.Open();
            stream.Write(new byte[entry == "anna/large" ? 100_000 : 10]);
        }
        if (entry == "anna/secret")
        {
            var bytes = File.ReadAllBytes(folder["class.zip"]);
            bytes[bytes.AsSpan().LastIndexOf("PK\u0001\u0002"u8) + 8] |= 1; // the flag of the last entry in the list
            File.WriteAllBytes(folder["class.zip"], bytes);
        }
        Assert.Contains(problem, Assert.Throws<ProblemException>(() => Archive.Unpack(folder["class.zip"], null, default, 50_000)).Message);
        Assert.False(Path.Exists(folder["class"]));
        Assert.False(Path.Exists(folder["evil"]) || Path.Exists("/tmp/evil"));
    }

    [Fact]
    public void ATableThatIsALinkIsNotFollowed()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "has no such file");
        Write("anna", RightProgram);
        Directory.CreateDirectory(folder["marks"]);
        File.CreateSymbolicLink(folder["marks/marks.csv"], "/dev/zero");
        Assert.EndsWith("marks.csv: it must be a file, no link, of 64 MB at most", Assert.Throws<ProblemException>(() => Mark()).Message);
    }

    [Theory]
    [InlineData("student,teacher's points,comment\nanna,many,", "the teacher's points of anna must be a number, but is \"many\"")]
    [InlineData("student,teacher's points,comment\nanna,,\"oops\nboris,3,", "a cell begins with a quote (\") and does not end with one")]
    [InlineData("student,teacher's points,comment\nanna,3,\nanna,4,", "has two rows of anna that say different things: delete one of them")]
    [InlineData("name;points\nanna;3", "has no column \"student\", \"teacher's points\" or \"comment\"")]
    public void ATableThatCannotBeReadIsRefusedBeforeTheWork(string table, string problem)
    {
        Write("anna", "touch \"$0.ran\"").WriteFile("marks/marks.csv", table);
        Assert.Contains(problem, Assert.Throws<ProblemException>(() => Mark()).Message);
        Assert.False(File.Exists(folder["class/anna/draw.sh.ran"]));
    }

    [Theory]
    [InlineData("draw.sh")]
    [InlineData("bin/draw.sh")] // folders of built files were left out
    public void AChangedProgramIsMarkedAnewThoughItsLengthAndTimeAreTheSame(string file)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        var script = folder[$"class/anna/{file}"];
        var (wrong, time) = ("exit 1".PadRight(RightProgram.Length), new DateTime(2020, 1, 1));
        Write("anna", wrong, file);
        if (file != "draw.sh") Write("anna", $". '{script}'");
        File.SetLastWriteTimeUtc(script, time);
        Assert.Equal("anna 0", PointsOf(Mark()));
        Assert.Equal("anna 0", PointsOf(Mark(resume: true)));
        File.WriteAllText(script, RightProgram);
        File.SetLastWriteTimeUtc(script, time);
        Assert.Equal("anna 5", PointsOf(Mark(resume: true)));
    }

    [Theory]
    [InlineData("ln -s ../bob/out out", "out")]
    [InlineData("mkdir out; ln -s ../../bob/out/ball.png out/ball.png", "out/ball.png")]
    public void ThePictureOfAnotherThatALinkLeadsToIsNotTaken(string links, string link)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "no links without rights there");
        WriteRubric(""" "pictures": "out/{name}.png", """);
        File.Copy(folder["shown/right.png"], WriteFile("class/bob/out/ball.png", ""), true);
        WriteFile("class/anna/notes", "");
        using (var shell = System.Diagnostics.Process.Start("sh", ["-c", $"cd '{folder["class/anna"]}'; {links}"])) shell.WaitForExit();
        var marks = Mark();
        Assert.Equal("anna 0, bob 5", PointsOf(marks));
        Assert.Equal($"ball: {link} is a link: the picture must be in the submission's folder", Assert.Single(marks[0].LookYourself));
    }

    [Fact]
    public void AProgramFindsNeitherThePictureBesideTheSceneNorItsFiles()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the programs are scripts of a POSIX shell");
        File.Copy(folder["shown/right.png"], folder["lab/ball.png"]);
        Write("beside", "cp \"${1%.json}.png\" \"$2\"").Write("above", "cp \"$(dirname \"$1\")/../lab/ball.png\" \"$2\"");
        Assert.Equal("above 0, beside 0", PointsOf(Mark(Containment.None)));
        Assert.SkipWhen(!Containment.Here.IsApart, "not allowed here");
        Write("absolute", $"cp '{folder["lab/ball.png"]}' \"$2\"");
        Assert.Equal("above 0, absolute 0, beside 0", PointsOf(Mark()));
    }

    [Fact] // the scene is another one, and so is its picture
    public void AProgramThatCopiesTheKnownPictureGetsNoPoints()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        Write("copies", RightProgram);
        Assert.Equal("copies 5", PointsOf(Mark()));
        WriteRubric(Draw + "\"vary\": true,");
        var marks = Mark();
        Assert.Equal("copies 0", PointsOf(marks));
        Assert.EndsWith("it is a copy", Assert.Single(marks[0].LookYourself));
    }

    [Fact]
    public void ARubricThatIsReplacedMeanwhileIsNoticed()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        Write("anna", $"echo '{{}}' >'{folder["rubric.json"]}'; {RightProgram}");
        Assert.Equal("anna 5", PointsOf(Mark(Containment.None)));
        Assert.Contains("was changed meanwhile: the marks are by what was read at the start", Assert.Single(notices));
    }

    [Fact]
    public void ASubmissionThatAnotherProgramHasChangedIsTold()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        Write("vandal", $"rm -rf '{folder["class"]}'").Write("victim", RightProgram);
        var marks = Mark(Containment.None);
        Assert.Equal("vandal 0, victim 0", PointsOf(marks));
        Assert.Contains("its files were changed after the run began", marks[1].LookYourself[0]);
    }

    [Theory]
    [InlineData("mkfifo", "marks.csv")]
    [InlineData("mkfifo", ".kept/anna.json")]
    [InlineData("mkfifo", "anna/feedback.html")]
    [InlineData("ln -s /dev/zero", ".kept/anna.json")]
    [InlineData("ln -s /dev/zero", "class.html")]
    public void APipeOrALinkAmongTheMarksIsReplaced(string command, string file)
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "has neither");
        Write("anna", RightProgram).Mark();
        File.Delete(folder["marks/" + file]);
        using (var shell = System.Diagnostics.Process.Start("sh", ["-c", $"{command} '{folder["marks/" + file]}'"])) shell.WaitForExit();
        Assert.Equal("anna 5", PointsOf(Mark(resume: true)));
        Assert.True(new FileInfo(folder["marks/" + file]) is { Length: > 0, LinkTarget: null });
    }

    [Fact]
    public void AProgramThatCallsTheLibrarysRendererIsFlaggedAndNotPunished()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        Write("calls", RightProgram).Write("own", RightProgram).Write("damaged", RightProgram);
        File.Copy(typeof(ClassMarksTests).Assembly.Location, WriteFile("class/calls/bin/Lab.dll", ""), true); // calls all sorts of things
        File.Copy(typeof(SceneReader).Assembly.Location, WriteFile("class/own/bin/RayCaster.Files.dll", ""), true); // is handed out
        WriteFile("class/damaged/Lab.dll", "MZ and no more");
        var marks = Mark();
        Assert.Equal("calls 5, damaged 5, own 5", PointsOf(marks));
        Assert.Contains("Lab.dll calls RayCaster.ScalarRenderer.Render", marks[0].LookYourself);
        Assert.Contains("Lab.dll calls Process.Start", marks[0].LookYourself);
        Assert.DoesNotContain(marks[0].LookYourself, note => note.Contains("PictureFile"));
        Assert.Empty(marks[1].LookYourself.Concat(marks[2].LookYourself));
    }

    [Fact]
    public void TheSameSourceWithOtherNamesIsListedAndNotScored()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        var source = string.Concat(Enumerable.Range(1, 30).Select(i => $"double f{i}(double x) {{ return x * {i} + \"#\"; }} // {i}\n"));
        Write("anna", RightProgram).Write("anna", source, "main.c");
        Write("boris", RightProgram);
        Write("boris", source.Replace("x", "längeX").Replace("{ ", "\n{\n\t").Replace("// ", "/* x */ //"), "src/other.c");
        Write("clara", RightProgram).Write("clara", source.Replace("* 7 ", "* 8 "), "main.c");
        var marks = Mark();
        Assert.Equal("anna 5, boris 5, clara 5", PointsOf(marks));
        Assert.Equal("the same source as boris, up to names and layout", Assert.Single(marks[0].LookYourself));
        Assert.Equal("the same source as anna, up to names and layout", Assert.Single(marks[1].LookYourself));
        Assert.Empty(marks[2].LookYourself);
    }

    [Fact]
    public void WhoeverRunsBesideAForkBombIsRunAgainAlone()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "elsewhere the number of processes is not known");
        WriteRubric(Draw + "\"processLimit\": 20,");
        Write("bomb", "b() { if [ $1 -gt 0 ]; then b $(($1-1)) & b $(($1-1)) & fi; sleep 20; }; touch \"$0.began\"; b 6");
        Write("neighbour", $"if [ -e \"$0.ran\" ]; then {RightProgram}; else touch \"$0.ran\"; sleep 3; exit 1; fi");
        Assert.Equal("bomb 0, neighbour 5", PointsOf(Mark(threads: 2)));
    }

    [Fact]
    public void AProgramThatNestsFoldersWithoutEndIsARow()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "the program is a script of a POSIX shell");
        Write("anna", "cd \"$TMPDIR\"; " +
            "p=$(printf 'd/%.0s' $(seq 420)); mkdir -p a/$p; for i in 2 3 4 5; do mkdir -p b/$p && mv a b/$p && mv b a || exit 1; done");
        Assert.Equal("ball: it wrote no picture", Assert.Single(Mark()[0].LookYourself));
    }
}
