using System.Diagnostics;

namespace RayCaster.Cli.Tests.HandOut;

/// <summary>What is in a hand-out, which is made once.</summary>
public sealed class HandOutFolderTests(HandOutFolderTests.Lab lab) : IClassFixture<HandOutFolderTests.Lab>
{
    public sealed class Lab : IDisposable
    {
        internal RayCasterProcess App { get; } = new RayCasterProcess().RunApart("", "handout", "lab1");

        public string this[string path] => App.PathOf(Path.Combine("lab1", path));

        public void Dispose() => App.Dispose();
    }

    [Fact]
    public void ItsStepsAndWhereToBeginAreTold() =>
        Assert.Equal((ExitCode.Done, "lab1: steps 1 to 10 are open; README.md says how to begin\n"), (lab.App.ExitCode, lab.App.Error));

    [Fact]
    public void NothingLiesBesideIt() => Assert.Equal(["lab1"], lab.App.Files);

    [Theory]
    [InlineData("README.md")]
    [InlineData("Lab.sln")]
    [InlineData("src/Lab/Lab.csproj")]
    [InlineData("tests/Lab.Tests/Step07Box.cs")]
    [InlineData("scenes/room.json")]
    [InlineData("scenes/meshes/knot.ply")]
    [InlineData("scenes/step07/room.png")]
    [InlineData("scenes/step10/mistakes/generic.png")]
    [InlineData(".github/workflows/classroom.yml")]
    [InlineData(".gitlab-ci.yml")]
    [InlineData(".gitignore")]
    [InlineData(".editorconfig")]
    [InlineData("Directory.Build.rsp")]
    [InlineData(".ci/restore.sh")]
    [InlineData(".ci/pictures.sh")]
    [InlineData(".devcontainer/devcontainer.json")]
    [InlineData(".vscode/tasks.json")]
    public void StudentsHave(string file) => Assert.True(File.Exists(lab[file]));

    [Fact]
    public void TheToolComesAlongButForWhatIsTheTeachers() => Assert.Equal(
        ["RayCaster.Engine.dll", "RayCaster.Files.dll", "RayCaster.Library.dll", "RayCaster.Page.dll", "RayCaster.Teaching.dll",
            "raycaster-live.dll",
            "raycaster-live.runtimeconfig.json", "raycaster.dll", "raycaster.runtimeconfig.json"],
        Directory.GetFiles(lab["lib"]).Select(file => Path.GetFileName(file)).Order(StringComparer.Ordinal));

    [Fact]
    public void NoFileHoldsTheSolution()
    {
        var solution = "Math.Sqrt(R * R - D * D)"; // a line of it
        Assert.Contains(solution, File.ReadAllText(ProjectFolder.PathOf("src/RayCaster.Lab/Sphere.cs")));
        Assert.All(Directory.GetFiles(lab[""], "*", SearchOption.AllDirectories).Where(file => !file.EndsWith(".png")), file =>
            Assert.False(File.ReadAllBytes(file).AsSpan().IndexOf(Encoding.UTF8.GetBytes(solution)) >= 0, file));
    }

    [Fact]
    public void ItsToolCompares() =>
        Assert.Equal((ExitCode.Done, ""), RunCarried("compare", "scenes/step10/room.png", "scenes/step10/room.png"));

    [Fact]
    public void ItsToolDoesNotMark() => Assert.Equal((ExitCode.Failed, "raycaster: RayCaster.Marks.dll is not beside this program, which may be " +
        "a hand-out's own: that one does not mark\n  Mark with a clone of the project, or with the installed tool.\n"),
        RunCarried("mark", "rubric.json"));

    [Fact]
    public void AFolderThatIsThereStaysAsItIs()
    {
        var before = Directory.GetLastWriteTimeUtc(lab[""]);
        using var raycaster = new RayCasterProcess();
        raycaster.Run("handout", lab[""]);
        Assert.Equal((ExitCode.Failed, $"raycaster: {lab[""]} exists already, and is not empty\n  Name a new folder: handout overwrites nothing.\n"),
            (raycaster.ExitCode, raycaster.Error));
        Assert.Equal(before, Directory.GetLastWriteTimeUtc(lab[""]));
    }

    private (int ExitCode, string Error) RunCarried(params string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet", [lab["lib/raycaster.dll"], .. arguments])
        {
            WorkingDirectory = lab[""],
            RedirectStandardOutput = true,
            RedirectStandardError = true,
        };
        using var program = Process.Start(start)!;
        var error = program.StandardError.ReadToEndAsync();
        program.StandardOutput.ReadToEnd();
        program.WaitForExit();
        return (program.ExitCode, error.Result.ReplaceLineEndings("\n"));
    }
}
