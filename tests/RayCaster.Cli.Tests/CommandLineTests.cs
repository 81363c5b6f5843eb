namespace RayCaster.Cli.Tests;

public sealed class CommandLineTests : CommandTests
{
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
        raycaster.Run("mark", "rubric.json", "--quite");
        Assert.Equal((2, """
            raycaster: unknown option '--quite'; did you mean '--quiet'?
            Usage:
              raycaster mark <rubric> <submissions> -o <folder> [options]
              raycaster mark <rubric>
            Try 'raycaster help mark', or dotnet run --project src/RayCaster.Cli -- help mark.

            """), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void EveryCommandHasItsUsageAndAPage() => Assert.All(Command.All, command =>
    {
        var (name, help) = (command.Key, command.Value.Help);
        Assert.EndsWith($"help{(name is "draw" or "help" ? "" : " " + name)}.\n", HelpCommand.HintAfter([name, "--no-such-option"]));
        Assert.All(help.Split('\n'), line => Assert.InRange(line.TrimEnd().Length, 0, 95));
    });

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

    [Theory]
    [InlineData("ROOM -o a.gif", "no picture format for 'a.gif': .gif is not known; use .png or .ppm")]
    [InlineData("ROOM -o no/a.png", "cannot write no/a.png: its folder does not exist")]
    [InlineData("ROOM -o ./ --format png", "cannot write ./: it is a folder; name a file in it")]
    [InlineData("ROOM --map z", "'z' is not a map: choose t, depth or model")]
    [InlineData("ROOM --map t -o a.png", "a map's numbers go to a file that ends in .pfm, but 'a.png' is given")]
    [InlineData("ROOM --map t --format ppm", "a map is a PFM and a PNG")]
    [InlineData("ROOM --mistake row", "'row' is not a mistake; did you mean 'rows'?")]
    [InlineData("ROOM --mistake rows --rows 1/2", "a wrong picture is drawn whole")]
    [InlineData("a.json --rows 5", "'5' names no lines: write the first and the last as in 0..249, counted from 0 at the top, " +
        "or 3/8 for the third of eight parts\n")]
    [InlineData("a.json --rows 9/8", "'9/8' names no lines")]
    [InlineData("a.json --rows 0..1 -o a.ppm", "--rows and --resume write a PNG, which records what it shows; choose another name or format\n")]
    [InlineData("a.json --resume --format ppm", "--rows and --resume write a PNG")]
    [InlineData("a.json --resume -o -", "--resume needs a file: it cannot check what was written to standard output\n")]
    [InlineData("a.json --missing", "option '--missing' belongs to a command: name the command\n")]
    [InlineData("ROOM -s 4x10 --rows 5..10", "the lines 5..10 do not all exist: a picture of 10 lines has 0..9\n")]
    [InlineData("ROOM -s 4x10 --rows 1/11", "a picture of 10 lines cannot be divided into 11 parts\n")]
    [InlineData("stitch", "no part is given: name files, a pattern or a folder\n")]
    [InlineData("stitch .", "stitch needs a name for the picture, as in -o room.png, or --missing to list the missing lines\n")]
    [InlineData("stitch . --missing -o a.png", "--missing writes no picture: leave -o out\n")]
    [InlineData("stitch . --missing", "there are no parts of a picture in .\n")]
    [InlineData("stitch part*.png --missing", "no file matches part*.png\n")]
    [InlineData("stitch a.png --missing", "picture file not found: a.png\n")]
    [InlineData("stitch . --rows 0..1", "option '--rows' is not one of stitch's\n")]
    [InlineData("orbit", "orbit takes <scene>, but nothing is given\n")]
    [InlineData("orbit a.json", "orbit needs a number of frames, as in --frames 48\n")]
    [InlineData("orbit a.json --frames 0", "'0' is not a number of frames: it is a whole number from 1 to 1,000,000\n")]
    [InlineData("orbit a.json --frames 8 --only 5..9", "the frames 5..9 do not all exist: a film of 8 frames has 0..7\n")]
    [InlineData("diagnose scene.json", "diagnose takes <scene> <mine>, but 'scene.json' is given")]
    [InlineData("diagnose a.json b.png --hint all", "'all' is not a level of hints: choose symptom, question or answer")]
    [InlineData("diagnose ROOM nothing.png", "picture file not found: nothing.png")]
    [InlineData("explain ROOM 500 0", "there is no column 500: the picture has columns 0 to 499, left to right")]
    [InlineData("explain ROOM 0 -1", "there is no line -1: the picture has lines 0 to 499, top to bottom")]
    [InlineData("explain ROOM x 0", "'x' is not a column: it is a whole number from 0 to 499")]
    [InlineData("check nosuch.json --for typo -q", "'typo' is not a kind of shape")]
    public void WhatCannotBeDoneIsRefused(string arguments, string message) =>
        Refuses(message, Array.ConvertAll(arguments.Split(' '), word => word == "ROOM" ? Room : word));

    [Fact]
    public void AMissingRubricIsNoAnswer() => Assert.Equal(2, raycaster.Run("mark", "nosuch.json").ExitCode);
}
