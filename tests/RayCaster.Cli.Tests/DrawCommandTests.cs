namespace RayCaster.Cli.Tests;

public sealed class DrawCommandTests : CommandTests
{
    [Fact]
    public void ThePictureIsNamedAfterTheSceneAndLiesInTheCurrentFolder()
    {
        raycaster.Run(Room);
        Assert.Equal(0, raycaster.ExitCode);
        Assert.Equal(["room.png"], raycaster.Files);
        var picture = PictureFile.Read(raycaster.PathOf("room.png"));
        Assert.Equal((500, 500), (picture.Width, picture.Height));
    }

    [Fact]
    public void OneLineTellsPictureSizeModelsTimeAndRaysPerSecond()
    {
        raycaster.Run(Room, "--size", "30x20");
        Assert.Matches(@"^room\.png: 30 x 20 pixels, 9 models, \d+\.\d\d s, (\d{1,3}(,\d{3})?|\d+\.\d million) rays per second\n$", raycaster.Error);
        Assert.Empty(raycaster.Output);
    }

    [Fact]
    public void QuietPrintsNothing()
    {
        raycaster.Run("-q", Room, "--size=30x20");
        Assert.Equal((0, ""), (raycaster.ExitCode, raycaster.Error));
    }

    [Fact]
    public void TheWordDrawMayComeFirst()
    {
        raycaster.Run("draw", Room, "-s", "30x20");
        Assert.Equal((0, "room.png"), (raycaster.ExitCode, Assert.Single(raycaster.Files)));
    }

    [Fact]
    public void PpmInReadableNumbersIsThereOnRequest()
    {
        raycaster.Run(Room, "-s", "4x2", "-o", "a.ppm", "--format", "ppm-text");
        Assert.StartsWith("P3\n4 2\n255\n", File.ReadAllText(raycaster.PathOf("a.ppm")));
    }

    [Fact(Skip = "no shell that shares a file", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void WhatOthersWriteToTheSameOutputStandsBeforeAndBehindThePicture()
    {
        raycaster.RunInShell($"""(echo before; raycaster '{Room}' -s 4x2 -o -; echo behind) >all 2>&1""");
        var all = Encoding.Latin1.GetString(File.ReadAllBytes(raycaster.PathOf("all")));
        Assert.StartsWith("before\nP6\n4 2\n255\n", all);
        Assert.Matches(@"^standard output: 4 x 2 pixels, .*\nbehind\n$", all[("before\n".Length + 11 + 4 * 2 * 3)..]);
    }

    [Fact(Skip = "no POSIX shell and signals there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void ThePictureIsDrawnWhereNobodyReadsTheMessages()
    {
        raycaster.RunInShell($"raycaster '{Room}' -s 4x2 -o closed.png 2>&-; raycaster '{Room}' -s 4x2 -o full.png 2>/dev/full");
        Assert.Equal(["closed.png", "full.png"], raycaster.Files);
    }

    [Fact]
    public void StandardOutputGetsTheBytesOfAPpm()
    {
        raycaster.Run(Room, "-s", "4x2", "-o", "-");
        Assert.Equal("P6\n4 2\n255\n", Encoding.ASCII.GetString(raycaster.Output, 0, 11));
        Assert.Equal(11 + 4 * 2 * 3, raycaster.Output.Length);
        Assert.Empty(raycaster.Files);
    }

    [Fact]
    public void ASceneComesFromStandardInput()
    {
        raycaster.Run(File.ReadAllText(Room), ["-", "-s", "4x2"]);
        Assert.Equal(["scene.png"], raycaster.Files);
    }

    /// <summary>What a command loads takes time. Without its list of assemblies the runtime looks for those only that it needs.</summary>
    [Fact(Skip = "no POSIX shell and signals there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public void DrawingLoadsTheLibraryTheFilesAndTheEngineOnly()
    {
        Directory.CreateDirectory(raycaster.PathOf("lib"));
        foreach (var name in (string[])
            ["raycaster.dll", "raycaster.runtimeconfig.json", "RayCaster.Library.dll", "RayCaster.Files.dll", "RayCaster.Engine.dll"])
            File.Copy(Path.Combine(AppContext.BaseDirectory, name), raycaster.PathOf($"lib/{name}"));
        raycaster.RunInShell($"dotnet lib/raycaster.dll '{Room}' -s 800x600");
        Assert.Matches(@"^room\.png: 800 x 600 pixels", raycaster.Error);
    }
}
