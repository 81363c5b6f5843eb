namespace RayCaster.Cli.Tests;

public sealed class PreviewTests : CommandTests
{
    [Fact]
    public void RedirectedItIsPlainAndAsLargeAsAUsualTerminal()
    {
        raycaster.Run(Room, "--preview", "-q", "--color", "auto");
        var lines = raycaster.OutputText.TrimEnd('\n').Split('\n');
        Assert.Equal((23, 46), (lines.Length, lines.Max(line => line.Length)));
        Assert.DoesNotContain('\e', raycaster.OutputText);
        Assert.Equal(["room.png"], raycaster.Files);
    }

    [Fact]
    public void ColoursAreThereOnRequest()
    {
        raycaster.Run(Room, "--preview", "-q", "--color=always", "-s", "6x4");
        Assert.StartsWith("\e[38;", raycaster.OutputText);
        Assert.Equal(12, raycaster.OutputText.Count(character => character == '▀'));
    }

    [Fact]
    public void AMapHasAPreviewToo()
    {
        raycaster.Run(Room, "--map", "model", "--preview", "-q", "-s", "6x4");
        Assert.Equal(2, raycaster.OutputText.Count(character => character == '\n'));
    }
}
