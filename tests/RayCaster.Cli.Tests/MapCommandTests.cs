namespace RayCaster.Cli.Tests;

public sealed class MapCommandTests : CommandTests
{
    [Fact]
    public void AMapIsAPictureNamedAfterSceneAndKind()
    {
        raycaster.Run("map", Room, "t", "-s", "30x20");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.Matches(@"^room\.t\.png: 30 x 20 pixels, t from \d+\.\d+ to \d+\.\d+\n$", raycaster.Error);
        var picture = PictureFile.Read(raycaster.PathOf("room.t.png"));
        Assert.Equal((30, 20), (picture.Width, picture.Height));
    }
}
