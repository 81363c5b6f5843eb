using System.Diagnostics;
using System.Text;

namespace RayCaster.Cli.Tests.HandOut;

public sealed class HandOutCommandTests : CommandTests
{
    [Fact]
    public void WritesAFolderWithAllThatStudentsNeedAndNoSolution()
    {
        raycaster.Run("handout", "lab1");
        Assert.Equal("lab1: steps 1 to 10 are open; README.md says how to begin\n", raycaster.Error);
        Assert.Equal(ExitCode.Done, raycaster.ExitCode);
        Assert.Equal(["lab1"], raycaster.Files);
        foreach (var file in (string[])[
            "README.md", "Lab.sln", "src/Lab/Lab.csproj", "tests/Lab.Tests/Step07Box.cs", "scenes/room.json", "scenes/meshes/knot.ply",
            "scenes/step07/room.png", "scenes/step10/mistakes/generic.png", ".github/workflows/classroom.yml", ".gitlab-ci.yml", ".gitignore",
            ".ci/restore.sh", ".ci/pictures.sh", ".devcontainer/devcontainer.json", ".vscode/tasks.json"])
            Assert.True(File.Exists(Path.Combine(raycaster.PathOf("lab1"), file)), file);
        Assert.Empty(Directory.EnumerateFiles(raycaster.PathOf("lab1"), "*OnlyHere*", SearchOption.AllDirectories));
        // The tool comes along, but for what is the teacher's: marks, and the solution, of which this is a line.
        var lib = Directory.GetFiles(Path.Combine(raycaster.PathOf("lab1"), "lib"));
        Assert.Equal(
            ["RayCaster.Engine.dll", "RayCaster.Files.dll", "RayCaster.Library.dll", "RayCaster.Teaching.dll", "raycaster-live.dll",
                "raycaster-live.runtimeconfig.json", "raycaster.dll", "raycaster.runtimeconfig.json"],
            lib.Select(file => Path.GetFileName(file)).Order(StringComparer.Ordinal));
        var secret = "Math.Sqrt(R * R - D * D)";
        Assert.Contains(secret, File.ReadAllText(ProjectFolder.PathOf("src/RayCaster.Lab/Sphere.cs")));
        foreach (var library in lib)
            Assert.False(File.ReadAllBytes(library).AsSpan().IndexOf(Encoding.UTF8.GetBytes(secret)) >= 0, $"{library} has the solution in it");
        File.WriteAllBytes(raycaster.PathOf("lab1/room.png"), File.ReadAllBytes(raycaster.PathOf("lab1/scenes/step10/room.png")));
        Assert.Equal(0, RunCarried(["compare", "room.png", "scenes/step10/room.png"]).ExitCode);
        Assert.Equal((ExitCode.Failed, "raycaster: RayCaster.Marks.dll is not beside this program, which may be a hand-out's own: that one does " +
            "not mark\n  Mark with a clone of the project, or with the installed tool.\n"), RunCarried(["mark", "rubric.json"]));
        // After the last step the picture is the scene's own.
        raycaster.Run(ProjectFolder.PathOf("scenes/circle.json"), "-q", "-o", "circle.png");
        var difference = new PictureDifference(
            PictureFile.Read(raycaster.PathOf("lab1/scenes/step10/circle.png")), PictureFile.Read(raycaster.PathOf("circle.png")));
        Assert.Equal(0, difference.Largest);

        raycaster.Run("handout", "lab1");
        Assert.Equal("raycaster: lab1 exists already, and is not empty\n  Name a new folder: handout overwrites nothing.\n", raycaster.Error);
        Assert.Equal(ExitCode.Failed, raycaster.ExitCode);
    }

    private (int ExitCode, string Error) RunCarried(string[] arguments)
    {
        var start = new ProcessStartInfo("dotnet", ["lib/raycaster.dll", .. arguments])
        {
            WorkingDirectory = raycaster.PathOf("lab1"),
            RedirectStandardError = true,
        };
        using var program = Process.Start(start)!;
        var error = program.StandardError.ReadToEnd();
        program.WaitForExit();
        return (program.ExitCode, error);
    }

    [Fact]
    public void AFolderThatCannotBeWrittenIsToldByItsOwnName()
    {
        raycaster.Write("file", "");
        raycaster.Run("handout", "file/lab1");
        Assert.StartsWith("raycaster: cannot write the folder file/lab1: ", raycaster.Error);
        Assert.DoesNotContain(".tmp", raycaster.Error);
        Assert.Equal(ExitCode.Failed, raycaster.ExitCode);
    }

    [Trait("waits", "yes")]
    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AnInterruptedRunLeavesNothing()
    {
        using var process = raycaster.Start("handout", "lab1");
        while (raycaster.Files.Length == 0 && !process.HasExited) Thread.Sleep(10);
        Assert.Equal(143, RayCasterProcess.Kill(process, "TERM"));
        Assert.Equal("raycaster: interrupted; nothing was written\n", process.StandardError.ReadToEnd());
        Assert.Empty(raycaster.Files);
    }

    [Theory]
    [InlineData("0..3")]
    [InlineData("4..2")]
    [InlineData("7..11")]
    [InlineData("box")]
    [InlineData("1..2..3")]
    public void StepsThatAreNoneAreAnError(string steps)
    {
        raycaster.Run("handout", "lab1", "--open", steps);
        Assert.StartsWith(
            $"raycaster: option '--open' takes one step of 1 to 10, or the first and the last as in 1..4, but '{steps}' is given\n",
            raycaster.Error);
        Assert.Equal(ExitCode.Failed, raycaster.ExitCode);
        Assert.Empty(raycaster.Files);
    }
}
