using System.Text.Json;

namespace RayCaster.Cli.Tests;

/// <summary>The console app's command compare, with real pictures of the project's scenes.</summary>
public sealed class CompareTests : IDisposable
{
    private static readonly string room = Path.Combine(RayCasterProcess.Scenes, "room.json");
    private static readonly string reference = ProjectFolder.PathOf("tests/References/room.png");

    private readonly RayCasterProcess app = new();

    public void Dispose() => app.Dispose();

    /// <summary>The room as the library draws it, with something done to it.</summary>
    private string Mine(Action<Picture>? change = null, string name = "mine.png")
    {
        var picture = Renderer.Render(RoomInTheReferencesSize());
        change?.Invoke(picture);
        PictureFile.Write(app.PathOf(name), picture);
        return name;
    }

    private static Scene RoomInTheReferencesSize()
    {
        var scene = SceneReader.Read(room).Scene!;
        var (width, height) = (PictureFile.Read(reference).Width, PictureFile.Read(reference).Height);
        return scene.WithSize(width, height);
    }

    private static void Flip(Picture picture)
    {
        var line = picture.Width * 3;
        for (var y = 0; y < picture.Height / 2; y++)
            for (var i = 0; i < line; i++)
            {
                var (a, b) = (y * line + i, (picture.Height - 1 - y) * line + i);
                (picture.Rgb[a], picture.Rgb[b]) = (picture.Rgb[b], picture.Rgb[a]);
            }
    }

    [Fact]
    public void AnIdenticalPictureIsTheSame()
    {
        app.Run("compare", Mine(), Mine(name: "other.ppm"));
        Assert.Equal((0, "mine.png and other.ppm are identical: 102,400 pixels.\n", ""), (app.ExitCode, app.OutputText, app.Error));
    }

    [Fact]
    public void ThePictureOfAnotherProgramIsTheSameButForOutlines()
    {
        app.Run("compare", Mine(), reference, "--scene", room);
        Assert.Equal(0, app.ExitCode);
        Assert.Matches(@"^mine\.png is right (within rounding|but for outlines): ", app.OutputText);
    }

    [Fact]
    public void AFlippedPictureIsDifferentAndRecognised()
    {
        app.Run("compare", Mine(Flip), Mine(name: "right.png"));
        Assert.Equal(1, app.ExitCode);
        Assert.Contains("\nFlipped top to bottom it is right: are rows written upside down?\n", app.OutputText);
    }

    [Fact]
    public void ATruncatedPictureIsDifferentWithTheReason()
    {
        var scene = RoomInTheReferencesSize();
        var hits = new Renderer(scene).CastHits();
        app.Run("compare", Mine(picture =>
        {
            for (var i = 0; i < hits.T.Length; i++)
            {
                var color = scene.Shade(hits.T[i], scene.Models[hits.Model[i]]);
                picture[i % hits.Width, i / hits.Width] = ((byte)(color.R * 255), (byte)(color.G * 255), (byte)(color.B * 255));
            }
        }), Mine(name: "right.png"));
        Assert.Equal(1, app.ExitCode);
        Assert.Matches(@"\n  [\d.]+ % of the pixels are one level darker: truncated instead of rounded\?\n", app.OutputText);
    }

    [Fact]
    public void AWrongPixelIsToldBothWays()
    {
        app.Run("compare", Mine(picture => picture[3, 2] = (1, 2, 3)), Mine(name: "right.png"));
        Assert.Contains("\n  In the middle of the widest wrong area: column 3, line 2 from the top (row 317 from the bottom): " +
            "(1, 2, 3) instead of (0, ", app.OutputText);
    }

    [Fact]
    public void WithTheSceneModelsAreNamed()
    {
        app.Write("room.json", File.ReadAllText(room).Replace("[1, 0, 1]", "[0, 1, 1]")).Run("room.json", "-o", "mine.png", "-q", "-s", "320x320");
        app.Run("compare", "mine.png", reference, "--scene", room);
        Assert.Equal(1, app.ExitCode);
        Assert.Contains("\n`box` has another colour: (0, 1, 1) instead of (1, 0, 1)", app.OutputText);
    }

    [Fact]
    public void WithoutAnOutputNothingIsWritten()
    {
        app.Run("compare", Mine(Flip), reference);
        Assert.Equal(["mine.png"], app.Files);
        Assert.EndsWith("To see the differences: -o difference.png\n", app.OutputText);
    }

    [Fact]
    public void TheOutputHoldsBothPicturesAndTheHeatMap()
    {
        app.Run("compare", Mine(Flip), reference, "-o", "difference.png");
        Assert.Equal(["difference.png", "mine.png"], app.Files);
        Assert.Equal(964, PictureFile.Read(app.PathOf("difference.png")).Width);
        Assert.EndsWith("difference.png: mine, the reference, the difference as a heat map\n", app.OutputText);
    }

    [Fact]
    public void MeasuresAreOneLine()
    {
        app.Run("compare", Mine(), Mine(name: "right.png"), "--measures");
        Assert.EndsWith("\nMeasures, in levels of 255: maximum 0, MAE 0, RMSE 0\n", app.OutputText);
    }

    [Fact]
    public void JsonHoldsTheAnswerByName()
    {
        app.Run("compare", Mine(Flip), Mine(name: "right.png"), "--scene", room, "--json");
        Assert.Equal(1, app.ExitCode);
        var answer = JsonDocument.Parse(app.Output).RootElement;
        Assert.Equal("wrong", answer.GetProperty("verdict").GetString());
        Assert.False(answer.GetProperty("same").GetBoolean());
        Assert.Equal("TopBottom", answer.GetProperty("recognised").GetProperty("turn").GetString());
        Assert.True(answer.GetProperty("scene").GetProperty("referenceIsItsPicture").GetBoolean());
        Assert.Equal(9, answer.GetProperty("scene").GetProperty("models").GetArrayLength());
        var first = answer.GetProperty("wrongMiddle");
        Assert.Equal(319, first.GetProperty("line").GetInt32() + first.GetProperty("row").GetInt32());
        Assert.InRange(answer.GetProperty("measures").GetProperty("rmse").GetDouble(), 1, 255);
    }

    [Fact]
    public void PicturesOfSwappedSidesAreDifferent()
    {
        PictureFile.Write(app.PathOf("a.png"), new Picture(30, 20));
        PictureFile.Write(app.PathOf("b.png"), new Picture(20, 30));
        app.Run("compare", "a.png", "b.png");
        Assert.Equal(1, app.ExitCode);
        Assert.StartsWith("a.png is wrong: it has 30 x 20 pixels, b.png has 20 x 30: width and height are swapped.\n", app.OutputText);
    }

    [Theory]
    [InlineData("picture file not found: missing.png", "mine.png", "missing.png")]
    [InlineData("compare takes <mine> <reference>", "mine.png")]
    [InlineData("no picture format for 'x.jpg'", "mine.png", "mine.png", "-o", "x.jpg")]
    [InlineData("not found", "mine.png", "mine.png", "--scene", "missing.json")]
    [InlineData("'--quiet' is not one of compare's", "mine.png", "mine.png", "--quiet")]
    public void WhatCannotBeComparedIsTold(string problem, params string[] arguments)
    {
        Mine();
        app.Run(["compare", .. arguments]);
        Assert.Equal((2, ""), (app.ExitCode, app.OutputText));
        Assert.Contains(problem, app.Error);
        Assert.Equal(["mine.png"], app.Files);
    }

    [Fact]
    public void HelpTellsTheOptions()
    {
        app.Run("help", "compare");
        Assert.Contains("--scene <file>", app.OutputText);
        Assert.All(app.OutputText.Split('\n'), line => Assert.InRange(line.Length, 0, 95));
    }
}
