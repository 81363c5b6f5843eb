using System.Text.RegularExpressions;

namespace RayCaster.Cli.Tests;

/// <summary>Parts of a picture, and the picture that they make, as commands.</summary>
public sealed class PartCommandTests : CommandTests
{
    [Fact]
    public void APartIsNamedAfterItsLines()
    {
        raycaster.Run("part", Room, "250..499", "-s", "30x500");
        Assert.Equal(["room.part-0250-0499.png"], raycaster.Files);
        Assert.StartsWith("room.part-0250-0499.png: lines 250..499 of 30 x 500 pixels, 9 models, ", raycaster.Error);
    }

    [Fact]
    public void NamesOfPartsOfATallPictureStandInOrder()
    {
        raycaster.Run("part", Room, "7..9", "-s", "1x12345");
        Assert.Equal(["room.part-00007-00009.png"], raycaster.Files);
    }

    [Fact]
    public void TheKthOfNPartsAreAllLines()
    {
        for (var k = 1; k <= 3; k++) raycaster.Run("part", Room, $"{k}/3", "-s", "10x100");
        Assert.Equal(["room.part-0000-0032.png", "room.part-0033-0065.png", "room.part-0066-0099.png"], raycaster.Files);
        raycaster.Run("stitch", ".", "--missing");
        Assert.Equal((0, "", ""), (raycaster.ExitCode, raycaster.OutputText, raycaster.Error));
    }

    [Theory]
    [InlineData("room.json")]
    [InlineData("mesh.json", Explicit = true)]
    public void StitchedPartsAreThePictureThatIsDrawnInOneGo(string scene)
    {
        var path = Path.Combine(RayCasterProcess.Scenes, scene);
        raycaster.Run(path, "-s", "200x150", "-o", "whole.png");
        foreach (var rows in (string[])["0..0", "1..63", "64..66", "67..149"]) raycaster.Run("part", path, rows, "-s", "200x150");
        raycaster.Run("stitch", "*.part-*.png", "-o", "stitched.png");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.Matches(@"^stitched\.png: 200 x 150 pixels, 4 parts, \d+\.\d\d s\n$", raycaster.Error);
        Assert.Equal(File.ReadAllBytes(raycaster.PathOf("whole.png")), File.ReadAllBytes(raycaster.PathOf("stitched.png")));
    }

    [Fact]
    public void AFolderIsItsPartsAndStandardOutputGetsAPpm()
    {
        raycaster.Run(Room, "-s", "20x10").Run("part", Room, "1/2", "-s", "20x10").Run("part", Room, "2/2", "-s", "20x10");
        raycaster.Run("stitch", ".", "-o", "-");
        Assert.Equal(PictureFile.Read(raycaster.PathOf("room.png")).Rgb, PictureFile.Read(new MemoryStream(raycaster.Output)).Rgb);
    }

    [Fact]
    public void MissingLinesAreToldAsPartTakesThemAndNothingIsWritten()
    {
        raycaster.Run("part", Room, "10..19", "-s", "20x100").Run("part", Room, "50..98", "-s", "20x100").Run("stitch", ".", "--missing");
        Assert.Equal((1, "0..9\n20..49\n99..99\n", ""), (raycaster.ExitCode, raycaster.OutputText, raycaster.Error));

        raycaster.Run("stitch", ".", "-o", "room.png");
        Assert.Equal((1, "raycaster: of 100 lines these are missing:\n  0..9\n  20..49\n  99..99\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal(2, raycaster.Files.Length);

        foreach (var rows in (string[])["0..9", "20..49", "99..99"]) raycaster.Run("part", Room, rows, "-s", "20x100");
        Assert.Equal(0, raycaster.Run("stitch", ".", "-o", "room.png").ExitCode);
    }

    [Theory]
    [InlineData("0/8", "1/8 to 8/8 (--array=1-8)")]
    [InlineData("9/8", "1/8 to 8/8 (--array=1-8)")]
    [InlineData("2/1", "1/1 to 1/1 (--array=1-1)")]
    [InlineData("99999999999/2", "1/2 to 2/2 (--array=1-2)")]
    public void APartThatDoesNotExistIsToldWithThoseThatDo(string part, string parts)
    {
        raycaster.Run("part", Room, part);
        Assert.Equal(2, raycaster.ExitCode);
        Assert.StartsWith($"raycaster: there is no part {part}: parts are {parts}\n", raycaster.Error);
    }

    /// <summary>Its lines are missing: they are to be drawn again.</summary>
    [Fact]
    public void DamagedPartsAreAllNamedAndTheirLinesAreMissing()
    {
        foreach (var rows in (string[])["0..9", "10..19", "20..29"]) raycaster.Run("part", Room, rows, "-s", "20x40", "-o", rows + ".png");
        foreach (var rows in (string[])["0..9", "20..29"]) Damage(rows + ".png");
        raycaster.Write("cut.png", "no picture");

        raycaster.Run("stitch", ".", "--missing");
        Assert.Equal((2, "0..9\n20..39\n"), (raycaster.ExitCode, raycaster.OutputText));
        Assert.Equal(["0..9.png", "20..29.png", "cut.png"], Named());

        raycaster.Run("part", Room, "30..39", "-s", "20x40", "-o", "30..39.png");
        File.Delete(raycaster.PathOf("cut.png"));
        raycaster.Run("stitch", ".", "-o", "room.png");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Equal(["0..9.png", "20..29.png"], Named());

        IEnumerable<string> Named() => Regex.Matches(raycaster.Error, "^raycaster: cannot read (?:.*[/\\\\])?(.*?): ", RegexOptions.Multiline)
            .Select(match => match.Groups[1].Value).Order(StringComparer.Ordinal);

        void Damage(string name)
        {
            var bytes = File.ReadAllBytes(raycaster.PathOf(name));
            bytes[^20] ^= 1; // within the pixels
            File.WriteAllBytes(raycaster.PathOf(name), bytes);
        }
    }

    [Fact]
    public void PartsOfDifferentScenesAreNotJoined()
    {
        raycaster.Write("room.png", "the old picture");
        raycaster.Write("a.json", File.ReadAllText(Room)).Write("b.json", File.ReadAllText(Room).Replace("\"fovY\": 45", "\"fovY\": 46"));
        raycaster.Run("part", "a.json", "1/2").Run("part", "b.json", "2/2").Run("stitch", "a.part*", "b.part*", "-o", "room.png");
        Assert.Equal(1, raycaster.ExitCode);
        Assert.StartsWith(
            "raycaster: these are not the parts of one picture:\n  b.part-0250-0499.png shows another scene than a.part-0000-0249.png: ",
                raycaster.Error);
        Assert.Equal("the old picture", File.ReadAllText(raycaster.PathOf("room.png")));
    }

    [Fact]
    public void WhatIsThereAlreadyIsNotDrawnAgain()
    {
        raycaster.Run("part", Room, "3/4", "-s", "40x40", "--resume");
        var before = raycaster.Files.Select(file => File.GetLastWriteTimeUtc(raycaster.PathOf(file))).ToArray();
        raycaster.Run("part", Room, "20..29", "-s", "40x40", "--resume");
        Assert.Equal((0, "room.part-0020-0029.png: exists already\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal(before, raycaster.Files.Select(file => File.GetLastWriteTimeUtc(raycaster.PathOf(file))));
    }

    [Fact]
    public void APartOfAnotherSceneIsDrawnAnew()
    {
        raycaster.Run("part", Room, "0..9", "-s", "40x40", "-o", "a.png").Run("part", Room, "0..9", "-s", "41x40", "-o", "a.png", "--resume");
        Assert.Contains("lines 0..9 of 41 x 40 pixels", raycaster.Error);
        Assert.Equal(41, PictureFile.Read(raycaster.PathOf("a.png")).Width);
    }

    [Fact(Explicit = true, Skip = "no kill command there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WhatAKilledPartLeavesIsFinishedByRunningAgain()
    {
        raycaster.Run(Part("0..9"));
        using (var process = raycaster.Start(Part("10..2989")))
        {
            WaitForTemporaryFile(process);
            Assert.Equal(137, RayCasterProcess.Kill(process, "KILL"));
        }
        raycaster.Run(Part("2990..2999")).Run("stitch", ".", "--missing");
        Assert.Equal((1, "10..2989\n"), (raycaster.ExitCode, raycaster.OutputText));

        var said = "";
        foreach (var lines in (string[])["0..9", "10..2989", "2990..2999"]) said += raycaster.Run([.. Part(lines), "--resume"]).Error;
        Assert.Matches(
            @"^room\.part-0000-0009\.png: exists already\nroom\.part-0010-2989\.png: lines .*\nroom\.part-2990-2999\.png: exists already\n$", said);
        Assert.Equal(0, raycaster.Run("stitch", ".", "--missing").ExitCode);

        string[] Part(string lines) => ["part", Room, lines, "-t", "1", "-s", "10000x3000"];
    }
}
