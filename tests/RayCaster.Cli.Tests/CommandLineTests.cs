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
    [InlineData("option '--size' takes width and height in pixels as in 640x480, but '640*480' is given\n", "a.json", "-s", "640*480")]
    [InlineData("option '--size' takes width and height in pixels as in 640x480, but '0x5' is given", "a.json", "-s", "0x5")]
    [InlineData("'1000001x1' is too large: width and height are at most 1,000,000, their product at most 10,000,000,000", "a", "-s", "1000001x1")]
    [InlineData("'1000000x1000000' is too large", "a.json", "-s", "1000000x1000000")]
    [InlineData("option '--threads' takes a whole number from 1 to 1,024, but 'many' is given", "a.json", "-t", "many")]
    [InlineData("option '--format' takes png, ppm or ppm-text, but 'jpg' is given", "a.json", "--format", "jpg")]
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
              raycaster mark <rubric> [<pictures>] [options]
            Try 'raycaster help mark', or dotnet run --project src/RayCaster.Cli -- help mark.

            """), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void EveryCommandHasAPageWithItsOptions() => Assert.All(new CommandList().All, command =>
    {
        var help = raycaster.Run("help", command.Name).OutputText;
        Assert.All(help.Split('\n'), line => Assert.InRange(line.TrimEnd().Length, 0, 90));
        Assert.All(command.Options, option => Assert.Contains($"\n  {option.Usage} ", help));
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
    [InlineData("there is no command 'chek'; did you mean 'check'?\n", "chek", "a.json")]
    [InlineData("there is no command 'chek'; did you mean 'check'?\n", "chek")]
    [InlineData("there is no command 'something'; a scene is drawn without one\n", "something", "a.json")]
    public void AWordThatIsNoCommandIsTold(string message, params string[] arguments) => Refuses(message, arguments);

    [Theory]
    [InlineData("ROOM -o a.gif", "no picture format for 'a.gif': .gif is not known; use .png or .ppm")]
    [InlineData("ROOM -o no/a.png", "cannot write no/a.png: its folder does not exist")]
    [InlineData("ROOM -o ./ --format png", "cannot write ./: it is a folder; name a file in it")]
    [InlineData("map ROOM z", "'z' is not a map: choose t, depth or model")]
    [InlineData("wrong ROOM row", "unknown name 'row' in 'row', a list of names joined by '+'; did you mean 'rows'?\n")]
    [InlineData("wrong ROOM rows,bgr", "unknown name 'rows,bgr' in 'rows,bgr', a list of names joined by '+'\n")]
    [InlineData("part a.json 5", "'5' names no lines: write the first and the last as in 0..249, counted from 0 at the top, " +
        "or 3/8 for the third of eight parts\n")]
    [InlineData("part a.json 9/8", "there is no part 9/8: parts are 1/8 to 8/8 (--array=1-8)")]
    [InlineData("part a.json 0..1 -o a.ppm", "a part is a PNG file, which records what it shows; choose another name\n")]
    [InlineData("part a.json 0..1 -o -", "a part is a PNG file, which records what it shows; choose another name\n")]
    [InlineData("part ROOM 5..10 -s 4x10", "there is no part 5..10 of a picture of 10 lines, 0..9\n")]
    [InlineData("part ROOM 1/11 -s 4x10", "there is no part 1/11 of a picture of 10 lines, 0..9\n")]
    [InlineData("a.json --missing", "unknown option '--missing'\n")]
    [InlineData("ROOM --rows 0..1", "unknown option '--rows'\n")]
    [InlineData("stitch", "no part is given: name files, a pattern or a folder\n")]
    [InlineData("stitch .", "stitch needs a name for the picture, as in -o room.png, or --missing to list the missing lines\n")]
    [InlineData("stitch . --missing -o a.png", "--missing writes no picture: leave -o out\n")]
    [InlineData("stitch . --missing", "there are no parts of a picture in .\n")]
    [InlineData("stitch part*.png --missing", "no file matches part*.png\n")]
    [InlineData("stitch a.png --missing", "picture file not found: a.png\n")]
    [InlineData("stitch . --size 9x9", "unknown option '--size'\n")]
    [InlineData("orbit", "orbit takes <scene>, but nothing is given\n")]
    [InlineData("orbit a.json", "orbit needs a number of frames, as in --frames 48\n")]
    [InlineData("orbit a.json --frames 0", "option '--frames' takes a whole number from 1 to 1,000,000, but '0' is given\n")]
    [InlineData("orbit a.json --frames 8 --only 5..9", "there are no frames 5..9 of 8, 0..7\n")]
    [InlineData("diagnose scene.json", "diagnose takes <scene> <mine>, but 'scene.json' is given")]
    [InlineData("diagnose a.json b.png --hint all", "option '--hint' takes symptom, question or answer, but 'all' is given\n")]
    [InlineData("diagnose ROOM nothing.png", "picture file not found: nothing.png")]
    [InlineData("explain ROOM 500 0", "there is no column 500: the picture has columns 0 to 499, left to right")]
    [InlineData("explain ROOM 0 -1", "there is no line -1: the picture has lines 0 to 499, top to bottom")]
    [InlineData("explain ROOM x 0", "'x' is not a column: it is a whole number from 0 to 499")]
    [InlineData("check week-*.json", "no file matches week-*.json\n")]
    [InlineData("check ROOM --for plane, sphere", "'sphere' seems to belong to the list of --for: write --for plane,sphere, without blanks")]
    [InlineData("check ROOM --require rows bgr", "'bgr' seems to belong to the list of --require: write --require rows,bgr, without blanks")]
    [InlineData("diagnose ROOM a.png --done plane sphere", "'sphere' seems to belong to the list of --done: write --done plane,sphere, without")]
    [InlineData("check nosuch.json --for typo -q", "unknown name 'typo' in 'typo', a list of names joined by ','")]
    public void WhatCannotBeDoneIsRefused(string arguments, string message) =>
        Refuses(message, Array.ConvertAll(arguments.Split(' '), word => word == "ROOM" ? Room : word));

    [Fact]
    public void AMissingRubricIsNoAnswer() => Assert.Equal(2, raycaster.Run("mark", "nosuch.json").ExitCode);
}
