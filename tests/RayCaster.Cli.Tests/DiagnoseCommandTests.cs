namespace RayCaster.Cli.Tests;

public sealed class DiagnoseCommandTests : CommandTests
{
    private const string scene = "scene.json"; // the first of the project's, made small

    public DiagnoseCommandTests() => raycaster.Write(scene, File.ReadAllText(Path.Combine(RayCasterProcess.Scenes, "first.json"))
        .Replace("\"target\"", "\"width\": 30, \"height\": 20, \"target\"", StringComparison.Ordinal));

    [Fact]
    public void ARightPictureIs0()
    {
        raycaster.Run(scene, "-o", "mine.png", "-q").Run("diagnose", scene, "mine.png");
        Assert.Equal(0, raycaster.ExitCode);
        Assert.StartsWith("mine.png matches", raycaster.OutputText);
    }

    [Fact]
    public void AWrongPictureIs1AndItsMistakeNamed()
    {
        var picture = PictureFile.Read(Draw("mine.png"));
        Some.Flip(picture);
        PictureFile.Write(raycaster.PathOf("wrong.png"), picture);

        raycaster.Run("diagnose", scene, "wrong.png");
        Assert.Equal((1, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.StartsWith("wrong.png is not the picture of scene.json: ", raycaster.OutputText);
        Assert.Contains(" differ by more than 1 level.\n", raycaster.OutputText);
        Assert.Contains("Most likely:\n  Symptom:  ", raycaster.OutputText);
        Assert.DoesNotContain("rows\n", raycaster.OutputText); // the mistake's name is its answer
        Assert.EndsWith("\n\nMore help: --hint answer\n", raycaster.OutputText);

        raycaster.Run("diagnose", scene, "wrong.png", "--hint", "answer");
        Assert.Contains("Most likely: rows\n", raycaster.OutputText);
        Assert.DoesNotContain("--hint", raycaster.OutputText);

        raycaster.Run("diagnose", scene, "wrong.png", "--json");
        using var json = System.Text.Json.JsonDocument.Parse(raycaster.Output);
        Assert.Equal("rows", json.RootElement.GetProperty("suspects")[0].GetProperty("mistakes")[0].GetProperty("id").GetString());
    }

    [Fact]
    public void APictureOfAnotherSizeIs1ThoughAllElseMatches()
    {
        raycaster.Run(scene, "-o", "mine.png", "-s", "15x10", "-q").Run("diagnose", scene, "mine.png");
        Assert.Equal(1, raycaster.ExitCode);
        Assert.StartsWith("mine.png is 15 x 10, not the scene's 30 x 20 pixels", raycaster.Error);
        Assert.StartsWith("mine.png matches", raycaster.OutputText);
    }

    private string Draw(string file)
    {
        raycaster.Run(scene, "-o", file, "-q");
        return raycaster.PathOf(file);
    }
}
