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

    [Fact]
    public void WhatIsThereAlreadyIsNotDrawnAgain()
    {
        raycaster.Run("part", Room, "3/4", "-s", "40x40", "--resume");
        var before = raycaster.Files.Select(file => File.GetLastWriteTimeUtc(raycaster.PathOf(file))).ToArray();
        raycaster.Run("part", Room, "20..29", "-s", "40x40", "--resume");
        Assert.Equal((0, "room.part-0020-0029.png: exists already\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.Equal(before, raycaster.Files.Select(file => File.GetLastWriteTimeUtc(raycaster.PathOf(file))));
    }
}
