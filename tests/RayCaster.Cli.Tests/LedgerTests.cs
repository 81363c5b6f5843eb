namespace RayCaster.Cli.Tests;

public sealed class LedgerTests : CommandTests
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
        raycaster.Write("away.json", LooksAway).Run("away.json", "-q", "--ledger");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void AUsualPictureHasALedgerOnRequest()
    {
        raycaster.Run(Room, "-s", "30x20");
        Assert.Single(raycaster.Error.TrimEnd().Split('\n'));
        raycaster.Run(Room, "-s", "30x20", "--ledger", "-o", "-");
        Assert.EndsWith("Nothing odd: every model shows.\n", raycaster.Error);
        Assert.Equal("P6\n30 20\n255\n".Length + 30 * 20 * 3, raycaster.Output.Length);
    }
}
