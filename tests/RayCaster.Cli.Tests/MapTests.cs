namespace RayCaster.Cli.Tests;

public sealed class MapTests : IDisposable
{
    private static readonly string Room = Path.Combine(RayCasterProcess.Scenes, "room.json");

    private readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

    [Fact]
    public void AMapIsNumbersAndAPictureNamedAfterSceneAndKind()
    {
        raycaster.Run(Room, "--map", "t", "-s", "30x20");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.Equal(["room.t.pfm", "room.t.png"], raycaster.Files);
        Assert.Matches(@"^room\.t\.pfm, room\.t\.png: 30 x 20 pixels, t from \d+\.\d+ to \d+\.\d+\n$", raycaster.Error);
        var picture = PictureFile.Read(raycaster.PathOf("room.t.png"));
        Assert.Equal((30, 20), (picture.Width, picture.Height));
        Assert.Equal("Pf\n30 20\n-1.0\n".Length + 4 * 600, new FileInfo(raycaster.PathOf("room.t.pfm")).Length);
    }

    [Fact]
    public void OutputNamesBothFiles()
    {
        raycaster.Run(Room, "--map=normal", "-s", "30x20", "-o", "n.pfm", "-q");
        Assert.Equal("", raycaster.Error);
        Assert.Equal(["n.normal.png", "n.pfm"], raycaster.Files);
    }

    [Theory]
    [InlineData("'z' is not a map: choose t, depth, model, normal or uv", "--map", "z")]
    [InlineData("a map's numbers go to a file that ends in .pfm, but 'a.png' is given", "--map", "t", "-o", "a.png")]
    [InlineData("a map is a PFM and a PNG", "--map", "t", "--format", "ppm")]
    [InlineData("the limit is 100,000,000", "--map", "t", "-s", "100000x100000")]
    public void WhatDoesNotFitAMapIsRefused(string message, params string[] arguments)
    {
        raycaster.Run([Room, .. arguments]);
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Contains(message, raycaster.Error);
        Assert.Empty(raycaster.Files);
    }
}
