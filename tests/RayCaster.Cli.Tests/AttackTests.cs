using System.Runtime.Versioning;

namespace RayCaster.Cli.Tests;

/// <summary>Odd names, odd folders and odd inputs: the program answers in a line, with exit code 2, and changes no file.</summary>
public sealed class AttackTests : CommandTests
{
    [Theory]
    [InlineData("stitch", "", "-o", "x.png")]
    [InlineData("compare", "a.png", "")]
    [InlineData("compare", "-o", "", "a.png", "a.png")]
    [InlineData("orbit", "--frames", "2", "")]
    [InlineData("")]
    public void AnEmptyNameIsRefused(params string[] arguments)
    {
        raycaster.Run(arguments);
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Matches(
            "^raycaster: (a name is empty: it names no file|option '--output' needs a value, but an empty one is given)\n", raycaster.Error);
    }

    [Theory]
    [InlineData("a\nraycaster: all is well.json", "U+000A")]
    [InlineData("a\r.json", "U+000D")]
    [InlineData("a\u202Egnp.json", "U+202E")]
    [InlineData("a\u2028b.json", "U+2028")]
    [InlineData("\u001b[2J.json", "U+001B")]
    public void ANameThatCouldForgeALineIsRefused(string name, string shown)
    {
        if (!OperatingSystem.IsWindows()) raycaster.Write(name, "{}");
        foreach (var arguments in (string[][])[[name], ["check", name], ["compare", name, name], [Room, "-s", "9x9", "-o", name]])
        {
            raycaster.Run(arguments);
            Assert.Equal(2, raycaster.ExitCode);
            Assert.Matches(
                $"^raycaster: '[^\n\r\u202E\u2028]+' holds the invisible character {shown.Replace("+", "\\+")}[^\n\r]+\n$", raycaster.Error);
        }
    }

    [Fact(Skip = "has no such names", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ANameInAFolderThatCouldForgeALineIsRefused()
    {
        Directory.CreateDirectory(raycaster.PathOf("frames"));
        raycaster.Write("frames/a\nb.png", "x").Run("stitch", "frames", "-o", "x.png");
        Assert.Equal(
            (2, "raycaster: 'a\uFFFDb.png' holds the invisible character U+000A: rename the file, or type the name again if it was copied\n"),
            (raycaster.ExitCode, raycaster.Error));
    }

    [Fact(Skip = "names are text elsewhere", SkipUnless = nameof(Here.IsLinux), SkipType = typeof(Here))]
    public void ANameThatIsNotUtf8IsRefused()
    {
        raycaster.RunInShell("raycaster \"$(printf 'a\\377.json')\"");
        Assert.Equal((2, "raycaster: the name 'a\uFFFD.json' is not UTF-8: rename the file\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void AModelsNameForgesNoLine()
    {
        raycaster.Write("a.json", """
            { "camera": { "position": [9, 0, 0], "target": [0, 0, 0], "width": 9, "height": 9 },
              "models": [ { "type": "sphere", "center": [0, 0, 0], "radius": 2, "name": "ball\r\nNothing odd\u202Edne\u001B[2J" } ] }
            """);
        foreach (var arguments in (string[][])[["models", "a.json"], ["explain", "a.json", "4", "4"]])
        {
            raycaster.Run(arguments);
            Assert.Equal(0, raycaster.ExitCode);
            foreach (var text in (string[])[raycaster.Error, raycaster.OutputText])
            {
                Assert.DoesNotMatch("[\r\u202E\u001B]", text);
                Assert.DoesNotContain("\nNothing odd\uFFFD", text);
            }
        }
    }

    [Fact(Skip = "no sh there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void APipeWhereAFileIsNeededIsRefused()
    {
        raycaster.RunInShell($"raycaster -q '{Room}' -s 9x9 -o a.png; cat a.png | raycaster stitch /dev/stdin -o x.png");
        Assert.Equal((2, "raycaster: cannot read /dev/stdin: it is a pipe or a device; name a file\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact(Skip = "has other rights", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    [UnsupportedOSPlatform("windows")]
    public void AFolderThatMayNotBeListedIsNamed()
    {
        Assert.SkipWhen(Here.ReadsEverything, "this user may read everything");
        Directory.CreateDirectory(raycaster.PathOf("locked"), UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        raycaster.Run("stitch", "locked", "-o", "x.png");
        File.SetUnixFileMode(raycaster.PathOf("locked"), UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute); // for its end
        Assert.Equal((2, "raycaster: cannot list the folder locked: you may not read it\n"), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact(Skip = "a current folder cannot be deleted there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ADeletedCurrentFolderIsReported()
    {
        raycaster.RunInShell("mkdir gone; cd gone; rmdir ../gone; raycaster nosuch.json");
        Assert.Equal((2, "raycaster: the current folder was deleted\n"), (raycaster.ExitCode, raycaster.Error));
    }

    /// <summary>This holds for every command, and for every path that leads to the file.</summary>
    [Fact(Skip = "links need rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WhatIsReadIsNotReplaced()
    {
        raycaster.Write("cube.obj", "v 0 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
        raycaster.Write(
            "t.json", """{ "camera": { "position": [9, 0, 0], "target": [0, 0, 0] }, "models": [ { "type": "mesh", "file": "cube.obj" } ] }""");
        Directory.CreateSymbolicLink(raycaster.PathOf("link"), raycaster.Folder);
        File.CreateSymbolicLink(raycaster.PathOf("alias.json"), "t.json");
        raycaster.Run("part", "t.json", "0..7", "-s", "8x8", "-o", "a.png", "-q");
        var before = Content();
        string[] commands =
        [
            "t.json -o t.json --format png",
            "t.json -o link/t.json --format png",
            "t.json -o alias.json --format png",
            "alias.json -o t.json --format png",
            "t.json -o cube.obj --format ppm",
            "wrong t.json rows -o cube.obj --format png",
            "compare a.png a.png -o link/a.png",
            "compare a.png a.png --scene t.json -o a.png",
            "stitch a.png -o a.png",
            "stitch a.png -o link/a.png",
        ];
        Assert.All(commands, command =>
        {
            raycaster.Run(command.Split(' '));
            Assert.Equal(2, raycaster.ExitCode);
            Assert.Contains(" is one of the files that are read\n  Choose another name with -o.\n", raycaster.Error);
            Assert.Equal(before, Content());
        });

        string[] Content() => [.. Directory.GetFiles(raycaster.Folder).Order().Select(file => file + Convert.ToHexString(File.ReadAllBytes(file)))];
    }

    [Fact]
    public void APictureThatDoesNotSayWhatItIsIsDrawnAnewWithAReason()
    {
        string[] part = ["part", Room, "1/1", "-s", "9x9", "-o", "room.png", "--resume"];
        raycaster.Run(Room, "-s", "9x9", "-q").Run(part);
        Assert.StartsWith("room.png is drawn again: it does not say which scene it shows; only parts and the frames of an orbit do\n",
            raycaster.Error);
        raycaster.Run(part);
        Assert.Equal("room.png: exists already\n", raycaster.Error);
    }

    [Theory]
    [InlineData("100000x1")]
    [InlineData("1x100000")]
    public void TheLedgerOfAPictureOfOneLineCountsRays(string size)
    {
        raycaster.Run("models", Room, "-s", size);
        Assert.DoesNotContain("0 of 0 rays", raycaster.OutputText);
        Assert.Matches("What became of", raycaster.OutputText);
    }

    [Fact]
    public void AnAngleInRadiansIsNotExplainedByNearness()
    {
        raycaster.Write("room.json", File.ReadAllText(Room).Replace("\"fovY\": 45", "\"fovY\": 0.785"));
        raycaster.Run("models", "room.json", "-s", "20x20");
        Assert.DoesNotContain("so near", raycaster.OutputText);
    }
}
