namespace RayCaster.Cli.Tests;

/// <summary>Parts of a picture, and the picture that they make, as commands.</summary>
[Trait("waits", "yes")]
public sealed class PartCampaign : CommandTests
{
    [Fact]
    public void SoAreThoseOfAMesh() => new PartTests().AssertStitched("mesh.json");

    [Fact]
    public void WhatAKilledPartLeavesIsFinishedByRunningAgain()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "no kill command there");
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
