namespace RayCaster.Cli.Tests;

public sealed class MapCommandTests : CommandTests
{
    [Fact]
    public void AMapIsNumbersAndAPictureNamedAfterSceneAndKind()
    {
        raycaster.Run("map", Room, "t", "-s", "30x20");
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
        raycaster.Run("map", Room, "depth", "-s", "30x20", "-o", "n.pfm", "-q");
        Assert.Equal("", raycaster.Error);
        Assert.Equal(["n.depth.png", "n.pfm"], raycaster.Files);
    }
}
