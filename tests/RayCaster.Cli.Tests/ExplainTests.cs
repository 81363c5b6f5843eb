using System.Text.Json;

namespace RayCaster.Cli.Tests;

/// <summary>The console app's explain.</summary>
public class ExplainTests : IDisposable
{
    private static readonly string Room = Path.Combine(RayCasterProcess.Scenes, "room.json");

    private readonly RayCasterProcess app = new();

    [Fact]
    public void TheAnswerGoesToStandardOutput()
    {
        app.Run("explain", Room, "250", "380");
        Assert.Equal((0, ""), (app.ExitCode, app.Error));
        Assert.StartsWith("Column 250, line 380 from the top (row r = 119 from the bottom) of 500 × 500 pixels:\n", app.OutputText);
    }

    [Fact]
    public void JsonCanBeRead()
    {
        app.Run("explain", Room, "10", "5", "--json", "--size", "20x10");
        Assert.Equal(0, app.ExitCode);
        Assert.Equal(4, JsonDocument.Parse(app.OutputText).RootElement.GetProperty("pixel").GetProperty("row").GetInt32());
    }

    [Theory]
    [InlineData("500", "0", "there is no column 500: the picture has columns 0 to 499, left to right")]
    [InlineData("0", "-1", "there is no line -1: the picture has lines 0 to 499, top to bottom")]
    [InlineData("x", "0", "'x' is not a column: it is a whole number from 0 to 499")]
    public void APixelOutsideOfThePictureIsAnErrorWithWhatIsAllowed(string column, string line, string message)
    {
        app.Run("explain", Room, column, line);
        Assert.Equal((2, ""), (app.ExitCode, app.OutputText));
        Assert.Contains(message, app.Error);
    }

    [Fact]
    public void AReferenceThatDiffersIsTheAnswerNo()
    {
        app.Run(Room, "-o", "mine.png", "-q");
        Assert.Equal(0, app.Run("explain", Room, "250", "380", "--reference", "mine.png").ExitCode);
        Assert.Contains("It has 138 0 138 here: the same", app.OutputText);
        app.Run(Room, "-o", "small.png", "-q", "--size", "10x10");
        Assert.Equal(2, app.Run("explain", Room, "250", "380", "--reference", "small.png").ExitCode);
        Assert.Contains("--size 10x10", app.Error);
        var other = PictureFile.Read(app.PathOf("mine.png"));
        other[250, 380] = (0, 0, 0);
        PictureFile.Write(app.PathOf("other.png"), other);
        Assert.Equal(1, app.Run("explain", Room, "250", "380", "--reference", "other.png").ExitCode);
        Assert.Contains("the background's", app.OutputText);
    }

    public void Dispose() => app.Dispose();
}
