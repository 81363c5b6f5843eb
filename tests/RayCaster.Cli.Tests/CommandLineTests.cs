namespace RayCaster.Cli.Tests;

public sealed class CommandLineTests : IDisposable
{
    private readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

    [Fact]
    public void WithoutArgumentsItShowsTheOneCommandToTry()
    {
        raycaster.Run();
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Empty(raycaster.Output);
        Assert.Contains("dotnet run --project src/RayCaster.Cli -- scenes/first.json", raycaster.Error);
        Assert.InRange(raycaster.Error.Split('\n').Length, 2, 6);
    }

    [Theory]
    [InlineData("help")]
    [InlineData("--help")]
    [InlineData("-h")]
    [InlineData("-?")]
    [InlineData("scene.json", "--help")]
    public void HelpThatIsAskedForGoesToStandardOutput(params string[] arguments)
    {
        raycaster.Run(arguments);
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.Contains("Usage:", raycaster.OutputText);
        Assert.All(raycaster.OutputText.Split('\n'), line => Assert.InRange(line.TrimEnd().Length, 0, 90));
    }

    [Fact]
    public void VersionIsBare()
    {
        raycaster.Run("--version");
        Assert.Matches(@"^\d+\.\d+\.\d+\s*$", raycaster.OutputText);
    }

    [Theory]
    [InlineData("unknown option '--ouput'; did you mean '--output'?", "--ouput", "a.png")]
    [InlineData("unknown option '-x'", "-x")]
    [InlineData("option '--size' is given twice", "-s", "1x1", "--size", "2x2")]
    [InlineData("option '--output' needs a value", "-o")]
    [InlineData("option '--quiet' takes no value, but 'yes' is given", "--quiet=yes")]
    [InlineData("'640*480' is not a size: write width and height in pixels as in 640x480\n", "a.json", "-s", "640*480")]
    [InlineData("'rows,bgr' is not a mistake; join names by '+', not by ','\n", "a.json", "--mistake", "rows,bgr")]
    [InlineData("'0x5' is not a size", "a.json", "-s", "0x5")]
    [InlineData("'1000001x1' is too large: width and height are at most 1,000,000, their product at most 10,000,000,000", "a", "-s", "1000001x1")]
    [InlineData("'1000000x1000000' is too large", "a.json", "-s", "1000000x1000000")]
    [InlineData("'many' is not a number of threads: it is a whole number from 1 to 1,024", "a.json", "-t", "many")]
    [InlineData("'jpg' is not a format: choose png, ppm or ppm-text", "a.json", "--format", "jpg")]
    [InlineData("one scene at a time, but there are 2: a.json, b.json\n", "a.json", "b.json")]
    [InlineData("one scene at a time, but there are 2: a.json, b.png; did you mean -o b.png?", "a.json", "b.png")]
    [InlineData("no scene is given", "--quiet")]
    public void AMistakeIsOneLineAndAHint(string message, params string[] arguments)
    {
        raycaster.Run(arguments);
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Empty(raycaster.Output);
        Assert.StartsWith("raycaster: " + message, raycaster.Error);
        Assert.EndsWith("\nTry 'raycaster help', or dotnet run --project src/RayCaster.Cli -- help.\n", raycaster.Error);
        Assert.Equal(3, raycaster.Error.Split('\n').Length);
    }

    [Fact]
    public void AMistakeOnACommandsLineShowsItsUsage()
    {
        raycaster.Run("mark", "rubric.json", "--resum");
        Assert.Equal((2, """
            raycaster: unknown option '--resum'; did you mean '--resume'?
            Usage:
              raycaster mark <rubric> <submissions> -o <folder> [options]
              raycaster mark <rubric>
            Try 'raycaster help mark', or dotnet run --project src/RayCaster.Cli -- help mark.

            """), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void EveryCommandHasItsUsage() => Assert.All(Command.All.Keys, name =>
        Assert.EndsWith($"help{(name is "draw" or "help" ? "" : " " + name)}.\n", HelpCommand.HintAfter([name, "--no-such-option"])));

    [Fact]
    public void AfterTwoDashesEverythingIsAScene()
    {
        raycaster.Run("--", "-q");
        Assert.Contains("-q: error: file not found", raycaster.Error);
    }

    [Fact]
    public void ANameWithABlankThatIsNotQuotedIsTold()
    {
        raycaster.Write("my scene.json", "{}").Run("my", "scene.json");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.StartsWith("raycaster: a file's name with blanks stands in quotes: \"my scene.json\"\n", raycaster.Error);
    }

    [Theory]
    [InlineData("compare", "compare", "a.png")]
    [InlineData("compare", "-o", "live", "compare", "a.png")]
    [InlineData(null, "big.json", "-o", "live")]
    [InlineData("mark", "--size", "9x9", "mark")]
    [InlineData(null, "draw", "live")]
    public void TheCommandIsTheFirstWordThatIsNoOption(string? command, params string[] arguments) =>
        Assert.Equal(command, Command.NameIn(arguments));

    [Fact]
    public void AMissingRubricIsNoAnswer() => Assert.Equal(2, raycaster.Run("mark", "nosuch.json").ExitCode);

    [Fact]
    public void OnePictureIsOne()
    {
        raycaster.Run(Path.Combine(RayCasterProcess.Scenes, "room.json"), "-s", "8x8", "-o", "a.png", "-q");
        Assert.StartsWith("sheet.png: 1 picture, ", raycaster.Run("sheet", "a.png", "-o", "sheet.png").Error);
    }
}
