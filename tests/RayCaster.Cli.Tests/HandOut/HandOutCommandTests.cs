namespace RayCaster.Cli.Tests.HandOut;

public sealed class HandOutCommandTests : CommandTests
{
    [Fact]
    public void AFolderThatCannotBeWrittenIsToldByItsOwnName()
    {
        raycaster.Write("file", "");
        raycaster.Run("handout", "file/lab1");
        Assert.StartsWith("raycaster: cannot write the folder file/lab1: ", raycaster.Error);
        Assert.DoesNotContain(".tmp", raycaster.Error);
        Assert.Equal(ExitCode.Failed, raycaster.ExitCode);
    }

    [Theory]
    [InlineData("lab%201", "%20")]
    [InlineData("lab@(1)/a", "@(")]
    [InlineData("lab...1", "...")]
    public void AFolderThatMSBuildCannotBuildInIsRefused(string folder, string part) =>
        Refuses($"{folder} could not be built: MSBuild misreads '{part}' in a path, as in ", "handout", folder);

    [Theory(Skip = "has no such names", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("*")]
    [InlineData("?")]
    [InlineData(":")]
    [InlineData("\\")]
    [InlineData("\"")]
    public void ACharacterThatMSBuildMisreadsIsRefused(string character) =>
        Refuses($"lab{character} could not be built: MSBuild misreads '{character}' in a path, as in ", "handout", $"lab{character}");

    [Fact(Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void AnInterruptedRunLeavesNothing()
    {
        using var process = raycaster.Start("handout", "lab1");
        WaitForTemporaryFile(process);
        Assert.Equal(143, RayCasterProcess.Kill(process, "TERM"));
        Assert.Equal("raycaster: interrupted; nothing was written\n", process.StandardError.ReadToEnd());
        Assert.Empty(raycaster.Files);
    }

    [Fact(Explicit = true)]
    public void AKilledRunLeavesNoHandOut()
    {
        using (var process = raycaster.Start("handout", "lab1"))
        {
            WaitForTemporaryFile(process);
            process.Kill(); // SIGKILL: it has no time to tidy
            process.WaitForExit();
        }
        Assert.Matches(@"^lab1\.([0-9a-f]{8})\.tmp$", Assert.Single(raycaster.Files));
        raycaster.Run("handout", "lab1", "-q");
        Assert.Equal((ExitCode.Done, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.Contains("lab1", raycaster.Files);
    }

    [Fact(Skip = "no such shell there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WithoutDotnetNoPageIsServedAndThatIsTold()
    {
        raycaster.Write("dotnet", "").Write("scene.json", "{}").RunInShell("chmod +x dotnet; PATH=.::/nowhere raycaster live scene.json");
        Assert.Equal((ExitCode.Failed, "raycaster: dotnet is not in PATH: install it, or add its folder to PATH\n"),
            (raycaster.ExitCode, raycaster.Error));
    }

    /// <summary>The program elsewhere, in a clone or not: no command builds what is missing.</summary>
    [Theory(Skip = "no such shell there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [InlineData("live scene.json", "true", "which is not beside this one\n  In a clone of the project: dotnet run ")]
    [InlineData("handout lab1", "true", "which is not beside this one\n  In a clone of the project: dotnet run ")]
    [InlineData("live scene.json", "mkdir scenes; touch RayCaster.sln", "which is not built with this one\n  Build it: dotnet build ")]
    [InlineData("handout lab1", "mkdir scenes; touch RayCaster.sln", "which is not built with this one\n  Build it: dotnet build ")]
    public void WithoutThePagesProgramItIsToldHowToGetIt(string command, string prepare, string said)
    {
        raycaster.Write("scene.json", "{}").RunInShell(
            $"{prepare}; cp -r '{Path.GetDirectoryName(RayCasterProcess.App)}' app; rm -f app/raycaster-live.dll; app/raycaster {command}");
        Assert.Equal(ExitCode.Failed, raycaster.ExitCode);
        Assert.Contains(said, raycaster.Error);
        Assert.DoesNotContain("lab1", raycaster.Files);
    }

    [Theory]
    [InlineData("0..3")]
    [InlineData("4..2")]
    [InlineData("7..11")]
    [InlineData("box")]
    [InlineData("1..2..3")]
    public void StepsThatAreNoneAreAnError(string steps) => Refuses(
        $"option '--open' takes one step of 1 to 10, or the first and the last as in 1..4, but '{steps}' is given\n",
        "handout", "lab1", "--open", steps);
}
