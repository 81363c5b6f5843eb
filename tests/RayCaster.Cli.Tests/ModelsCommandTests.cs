namespace RayCaster.Cli.Tests;

public sealed class ModelsCommandTests : CommandTests
{
    private const string LooksAway = """
        { "camera": { "position": [-9, 0, 0], "target": [-12, 0, 0], "width": 30, "height": 20 },
          "models": [ { "type": "sphere", "center": [0, 0, 0], "radius": 2, "name": "ball" } ] }
        """;

    [Fact]
    public void AnEmptyPictureTellsByItselfWhy()
    {
        raycaster.Write("away.json", LooksAway).Run("away.json");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.Contains("\n0 of 600 rays hit anything: ball lies behind the camera.\n", raycaster.Error);
    }

    [Fact]
    public void QuietIsQuiet()
    {
        raycaster.Write("away.json", LooksAway).Run("away.json", "-q");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void AUsualPictureIsOneLineAndModelsSaysThatAllShow()
    {
        raycaster.Run(Room, "-s", "30x20");
        Assert.Single(raycaster.Error.TrimEnd().Split('\n'));
        raycaster.Run("models", Room, "-s", "30x20");
        Assert.EndsWith("Nothing odd: every model shows.\n", raycaster.OutputText);
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }
}
