namespace RayCaster.Cli.Tests;

/// <summary>The console app's explain.</summary>
public sealed class ExplainCommandTests : CommandTests
{
    [Fact]
    public void TheAnswerGoesToStandardOutput()
    {
        raycaster.Run("explain", Room, "250", "380");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
        Assert.StartsWith("Column 250, line 380 from the top (row r = 119 from the bottom) of 500 × 500 pixels:\n", raycaster.OutputText);
    }

    [Fact]
    public void AReferenceThatDiffersIsTheAnswerNo()
    {
        raycaster.Run(Room, "-o", "mine.png", "-q");
        Assert.Equal(0, raycaster.Run("explain", Room, "250", "380", "--mine", "mine.png").ExitCode);
        Assert.Contains("It has 138 0 138 here: the same", raycaster.OutputText);
        raycaster.Run(Room, "-o", "small.png", "-q", "--size", "10x10");
        Assert.Equal(2, raycaster.Run("explain", Room, "250", "380", "--mine", "small.png").ExitCode);
        Assert.Contains("--size 10x10", raycaster.Error);
        var other = PictureFile.Read(raycaster.PathOf("mine.png"));
        other[250, 380] = (0, 0, 0);
        PictureFile.Write(raycaster.PathOf("other.png"), other);
        Assert.Equal(1, raycaster.Run("explain", Room, "250", "380", "--mine", "other.png").ExitCode);
        Assert.Contains("the background's", raycaster.OutputText);
    }
}
