namespace RayCaster.Cli.Tests;

public sealed class PreviewTests : IDisposable
{
    private static readonly string Room = Path.Combine(RayCasterProcess.Scenes, "room.json");

    private readonly RayCasterProcess raycaster = new();

    public void Dispose() => raycaster.Dispose();

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

    [Theory]
    [InlineData("--preview and -o - both write to standard output", "--preview", "-o", "-")]
    [InlineData("'yes' is not a value of --color: choose auto, always or never", "--color", "yes")]
    public void WhatCannotBeIsRefused(string message, params string[] arguments)
    {
        raycaster.Run([Room, .. arguments]);
        Assert.Equal((2, ""), (raycaster.ExitCode, raycaster.OutputText));
        Assert.Contains(message, raycaster.Error);
        Assert.Empty(raycaster.Files);
    }
}
