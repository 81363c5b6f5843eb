namespace RayCaster.Cli.Tests;

public sealed class DiagnoseTests : IDisposable
{
    private readonly RayCasterProcess raycaster = new();
    private const string scene = "scene.json"; // the first of the project's, made small

    public DiagnoseTests() => raycaster.Write(scene, File.ReadAllText(Path.Combine(RayCasterProcess.Scenes, "first.json"))
        .Replace("\"target\"", "\"width\": 30, \"height\": 20, \"target\"", StringComparison.Ordinal));

    public void Dispose() => raycaster.Dispose();

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
        var upsideDown = new Picture(picture.Width, picture.Height);
        for (var y = 0; y < picture.Height; y++)
            for (var x = 0; x < picture.Width; x++) upsideDown[x, y] = picture[x, picture.Height - 1 - y];
        PictureFile.Write(raycaster.PathOf("wrong.png"), upsideDown);

        raycaster.Run("diagnose", scene, "wrong.png");
        Assert.Equal((1, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.StartsWith("wrong.png is not the picture of scene.json: ", raycaster.OutputText);
        Assert.Contains(" differ by more than 1 level.\n", raycaster.OutputText);
        Assert.Contains("Most likely: rows", raycaster.OutputText);
        Assert.EndsWith("\n\nMore help: --hint answer\n", raycaster.OutputText);

        raycaster.Run("diagnose", scene, "wrong.png", "--hint", "answer");
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

    [Theory]
    [InlineData("diagnose takes <scene> <mine>, but 'scene.json' is given", "diagnose", "scene.json")]
    [InlineData("'all' is not a level of hints: choose symptom, question or answer", "diagnose", "a.json", "b.png", "--hint", "all")]
    [InlineData("option '--size' is not one of diagnose's", "diagnose", "a.json", "b.png", "--size", "1x1")]
    public void AMistakeOnTheCommandLineIs2(string message, params string[] arguments)
    {
        raycaster.Run(arguments);
        Assert.Equal((2, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.StartsWith("raycaster: " + message, raycaster.Error);
    }

    [Fact]
    public void APictureThatIsNotThereIs2()
    {
        raycaster.Run("diagnose", scene, "nothing.png");
        Assert.Equal(2, raycaster.ExitCode);
        Assert.StartsWith("raycaster: picture file not found: nothing.png", raycaster.Error);
    }

    private string Draw(string file)
    {
        raycaster.Run(scene, "-o", file, "-q");
        return raycaster.PathOf(file);
    }
}
