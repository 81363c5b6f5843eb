namespace RayCaster.Cli.Tests;

public class TerminalPreviewTests
{
    private static readonly byte[] Red = [255, 0, 0], Blue = [0, 0, 255], White = [255, 255, 255], Black = [0, 0, 0], Grey = [128, 128, 128];

    [Fact]
    public void ABlockShowsTwoPixelsUponEachOther() =>
        Assert.Equal(
            "\e[38;2;255;0;0m\e[48;2;0;0;255m▀\e[38;2;255;255;255m\e[48;2;0;0;0m▀\e[0m\n", Text(ColorDepth.Full, 2, 2, Red, White, Blue, Black));

    [Fact]
    public void AColourIsNamedOnlyWhereItChanges() =>
        Assert.Equal("\e[38;2;255;0;0m\e[48;2;0;0;0m▀▀\e[48;2;0;0;255m▀\e[0m\n", Text(ColorDepth.Full, 3, 2, Red, Red, Red, Black, Black, Blue));

    [Fact]
    public void BelowTheLastLineTheTerminalsOwnColourShows() =>
        Assert.Equal("\e[38;2;255;0;0m▀\e[0m\n", Text(ColorDepth.Full, 1, 1, Red));

    [Fact]
    public void ATerminalOf256ColoursGetsTheNearest() =>
        Assert.Equal("\e[38;5;196m\e[48;5;21m▀\e[38;5;231m\e[48;5;16m▀\e[38;5;244m\e[48;5;172m▀\e[0m\n",
            Text(ColorDepth.Palette, 3, 2, Red, White, Grey, Blue, Black, [210, 130, 5]));

    [Fact]
    public void WithoutColoursACharacterIsAsBrightAsItsPixels()
    {
        Assert.Equal("@:+\n", Text(ColorDepth.None, 4, 2, White, Red, Grey, Black, White, Red, Grey, Black)[..3] + "\n");
        Assert.Equal("=\n", Text(ColorDepth.None, 1, 2, White, Black));
        Assert.Equal("@\n", Text(ColorDepth.None, 2, 1, White, Black)); // blanks at a line's end are left out
    }

    [Fact]
    public void ACellHasTheMeanOfItsPixels()
    {
        var preview = new TerminalPreview(4, 4, columns: 2, lines: 1);
        for (var i = 0; i < 4; i++) preview.Take([.. Red, .. Black, .. White, .. White]); // line by line
        Assert.Equal("\e[38;2;128;0;0m\e[48;2;128;0;0m▀\e[38;2;255;255;255m\e[48;2;255;255;255m▀\e[0m\n", preview.Text(ColorDepth.Full));
    }

    [Theory]
    [InlineData(400, 100, 80, 10)] // as wide as the terminal
    [InlineData(100, 400, 12, 23)] // as high
    [InlineData(10, 6, 10, 3)]     // smaller than it
    [InlineData(1000000, 1, 80, 1)]
    [InlineData(1, 1000, 1, 23)]
    public void ThePictureFitsAndKeepsItsShape(int width, int height, int columns, int lines)
    {
        var preview = new TerminalPreview(width, height, 80, 23);
        var line = new byte[3 * width];
        Array.Fill(line, (byte)255);
        for (var y = 0; y < height; y++) preview.Take(line);
        var shown = preview.Text(ColorDepth.None).TrimEnd('\n').Split('\n');
        Assert.Equal((columns, lines), (shown[0].Length, shown.Length));
        Assert.All(shown, text => Assert.Equal(new string('@', columns), text));
    }

    [Theory]
    [InlineData("None", null, true)]
    [InlineData("Palette", null, false)]
    [InlineData("Palette", "auto", false, "TERM=xterm-256color")]
    [InlineData("Full", null, false, "COLORTERM=truecolor")]
    [InlineData("Full", null, false, "COLORTERM=24bit", "NO_COLOR=")]
    [InlineData("Full", null, false, "TERM=xterm-direct")]
    [InlineData("Full", null, false, "WT_SESSION=1")]
    [InlineData("None", null, false, "TERM=dumb")]
    [InlineData("None", null, false, "NO_COLOR=1", "COLORTERM=truecolor")]
    [InlineData("None", null, false, "NO_COLOR=1", "FORCE_COLOR=1")]
    [InlineData("Full", null, true, "FORCE_COLOR=1", "COLORTERM=truecolor")]
    [InlineData("Palette", "always", true, "NO_COLOR=1")]
    [InlineData("Palette", "always", true, "TERM=dumb")]
    [InlineData("None", "never", false, "FORCE_COLOR=1")]
    public void ColoursAreUsedWhereTheyAreWelcome(string depth, string? when, bool isRedirected, params string[] variables)
    {
        string? Variable(string name) => Array.Find(variables, text => text.StartsWith(name + "="))?[(name.Length + 1)..];
        Assert.Equal(Enum.Parse<ColorDepth>(depth), TerminalScreen.Choose(when, isRedirected, Variable));
    }

    private static string Text(ColorDepth depth, int width, int height, params byte[][] pixels)
    {
        var preview = new TerminalPreview(width, height, 80, 24);
        preview.Take([.. pixels.SelectMany(pixel => pixel)]);
        return preview.Text(depth);
    }
}
