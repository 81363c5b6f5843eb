using System.Text.Json;

namespace RayCaster.Cli.Tests;

/// <summary>Wrong pictures on purpose, and what a scene must show.</summary>
public sealed class WrongCommandTests : CommandTests
{
    [Fact]
    public void AWrongPictureIsDrawn()
    {
        raycaster.Run("wrong", Room, "rows+bgr", "-s", "60x60");
        Assert.Equal((0, true), (raycaster.ExitCode, raycaster.Files.Contains("room.rows+bgr.png")));
        Assert.StartsWith("room.rows+bgr.png: wrong on purpose: row r written as line r", raycaster.Error);
    }

    [Fact]
    public void AWrongPictureThatDoesNotFitIntoMemoryIsRefused()
    {
        raycaster.Run("wrong", Room, "rows", "--size", "30000x30000");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.Contains("30,000 × 30,000 pixels needs 2,700,000,000 bytes, the limit is ", raycaster.Error);
    }

    [Fact]
    public void AMistakeThatALargeMeshDoesNotShowIsToldAsThat()
    {
        raycaster.Run("wrong", Path.Combine(RayCasterProcess.Scenes, "mesh.json"), "tri-uv", "-s", "20x20");
        Assert.StartsWith("tri-uv: a large mesh is drawn rightly all the same", raycaster.Error);
    }

    [Fact]
    public void JsonIsOnStandardOutputWhateverIsInTheWay()
    {
        raycaster.Run("diagnose", Room, "nothing.png", "--json");
        Assert.Equal(2, raycaster.ExitCode);
        using var json = JsonDocument.Parse(raycaster.Output);
        Assert.Equal("could not tell", json.RootElement.GetProperty("finding").GetString());
    }

    /// <summary>The shells of Windows expand no patterns.</summary>
    [Fact]
    public void CheckReadsTheScenesOfAPattern()
    {
        raycaster.Write("week-1.json", "{").Write("week-2.json", "{").Write("other.json", "{").Run("check", "week-*.json");
        Assert.Equal(1, raycaster.ExitCode);
        Assert.Contains("week-1.json(1,", raycaster.OutputText);
        Assert.Contains("week-2.json(1,", raycaster.OutputText);
        Assert.DoesNotContain("other", raycaster.OutputText);
    }

    [Fact]
    public void CheckAnswersForTheShapesOfAWeekAndForWhatIsRequired()
    {
        raycaster.Write(
            "small.json", File.ReadAllText(Room).Replace("\"width\": 500", "\"width\": 30").Replace("\"height\": 500", "\"height\": 30"));
        raycaster.Run("check", "small.json", "--for", "plane,sphere", "--require", "rows,aspect-inv");
        Assert.Equal((1, "required, but not shown: aspect-inv\n"), (raycaster.ExitCode, raycaster.Error));
        Assert.DoesNotContain(" tri-", raycaster.OutputText);
        Assert.Equal(0, raycaster.Run("check", "small.json", "-q", "--require", "rows,bgr").ExitCode);
    }
}
