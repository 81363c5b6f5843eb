namespace RayCaster.Cli.Tests;

/// <summary>The console app's command compare, with real pictures of the project's scenes.</summary>
public sealed class CompareCommandTests : CommandTests
{
    private static readonly string reference = ProjectFolder.PathOf("tests/References/room.png");

    /// <summary>The room as the library draws it, with something done to it.</summary>
    private string Mine(Action<Picture>? change = null)
    {
        var picture = Renderer.Render(RoomInTheReferencesSize());
        change?.Invoke(picture);
        PictureFile.Write(raycaster.PathOf("mine.png"), picture);
        return "mine.png";
    }

    private static Scene RoomInTheReferencesSize()
    {
        var scene = SceneReader.Read(Room).Scene!;
        var (width, height) = (PictureFile.Read(reference).Width, PictureFile.Read(reference).Height);
        return scene.WithSize(width, height);
    }

    [Fact]
    public void ThePictureOfAnotherProgramIsTheSameButForOutlines()
    {
        raycaster.Run("compare", Mine(), reference, "--scene", Room);
        Assert.Equal(0, raycaster.ExitCode);
        Assert.Matches(@"^mine\.png is right (within rounding|but for outlines): ", raycaster.OutputText);
    }

    [Fact]
    public void WithoutAnOutputNothingIsWritten()
    {
        raycaster.Run("compare", Mine(Some.Flip), reference);
        Assert.Equal(["mine.png"], raycaster.Files);
        Assert.EndsWith("To see the differences: -o difference.png\n", raycaster.OutputText);
    }

    [Fact]
    public void TheOutputHoldsBothPicturesAndTheHeatMap()
    {
        raycaster.Run("compare", Mine(Some.Flip), reference, "-o", "difference.png");
        Assert.Equal(["difference.png", "mine.png"], raycaster.Files);
        Assert.Equal(964, PictureFile.Read(raycaster.PathOf("difference.png")).Width);
        Assert.EndsWith("difference.png: mine, the reference, the difference as a heat map\n", raycaster.OutputText);
    }

    [Theory]
    [InlineData("picture file not found: missing.png", "mine.png", "missing.png")]
    [InlineData("compare takes <mine> <reference>", "mine.png")]
    [InlineData("no picture format for 'x.jpg'", "mine.png", "mine.png", "-o", "x.jpg")]
    [InlineData("unknown option '--quiet'", "mine.png", "mine.png", "--quiet")]
    public void WhatCannotBeComparedIsTold(string problem, params string[] arguments)
    {
        Mine();
        Refuses(problem, ["compare", .. arguments]);
    }
}
