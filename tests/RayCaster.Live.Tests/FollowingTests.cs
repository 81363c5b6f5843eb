using System.Diagnostics;
using System.Text.Json;

namespace RayCaster.Live.Tests;

/// <summary>The picture follows the scene file, in whatever way it is saved and whatever it contains.</summary>
public class FollowingTests
{
    private static string Moved(double x) => LivePage.Ball.Replace("[6, 0, 2.5]", FormattableString.Invariant($"[{x}, 0, 2.5]"));

    [Fact]
    public async Task ThePictureIsTheDefinitions()
    {
        await using var page = await LivePage.OpenAsync();
        await page.ConnectAsync();
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    [Theory]
    [InlineData("in place")]
    [InlineData("by rename")]
    [InlineData("in two steps")]
    [InlineData("emptied first")]
    [InlineData("gone for a moment")]
    public async Task ASavedSceneIsANewPictureAndNoErrorFlashes(string how)
    {
        await using var page = await LivePage.ShownAsync();
        for (var version = 2; version <= 3; version++)
        {
            Save(page, Moved(5 + version), how);
            var said = await page.MessageAsync("scene");
            Assert.True(said.GetProperty("good").GetBoolean(), said.ToString());
            Assert.Equal(version, said.GetProperty("version").GetInt32());
            (await page.FrameAsync()).IsThatOf(page.Scene);
        }
    }

    /// <summary>As on a file system whose times are so coarse that two saves have the same.</summary>
    [Fact]
    public async Task ASaveOfTheSameTimeAndLengthIsANewPicture()
    {
        await using var page = await LivePage.ShownAsync();
        var time = page.Clock!.GetUtcNow().UtcDateTime.AddMinutes(5);
        await SaveAsync(7);
        page.Clock.Advance(TimeSpan.FromMinutes(5));
        await SaveAsync(8);

        async Task SaveAsync(int x)
        {
            File.WriteAllText(page.Folder["new"], Moved(x));
            File.SetLastWriteTimeUtc(page.Folder["new"], time);
            File.Move(page.Folder["new"], page.Scene, overwrite: true);
            (await page.FrameAsync()).IsThatOf(page.Scene);
        }
    }

    [Fact]
    public async Task ABrokenSceneKeepsTheLastGoodPictureAndTellsAllErrorsWithTheirPlaces()
    {
        await using var page = await LivePage.ShownAsync();
        File.WriteAllText(page.Scene, LivePage.Ball.Replace("\"radius\": 1", "\"raduis\": 1").Replace("[6, 0, 2.5]", "[6, 0]"));
        var said = await page.MessageAsync("scene", message => !message.GetProperty("good").GetBoolean());
        var problems = said.GetProperty("problems").EnumerateArray().ToArray();
        Assert.Equal(3, problems.Length);
        Assert.Equal($"{page.Scene}:3:27", problems[0].GetProperty("place").GetString());
        Assert.EndsWith("scene.json:3:27", problems[0].GetProperty("link").GetString());
        Assert.StartsWith("vscode://file/", problems[0].GetProperty("link").GetString());
        Assert.Contains("^~~~", problems[0].GetProperty("excerpt").GetString());
        Assert.Equal(40, said.GetProperty("width").GetInt32());

        File.WriteAllText(page.Scene, Moved(9));
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    [Fact]
    public async Task ASceneFileThatBecomesAFolderIsToldAsOneAndComesBack()
    {
        await using var page = await LivePage.ShownAsync();
        File.Delete(page.Scene);
        await page.MessageAsync("scene", message => message.GetProperty("isGone").GetBoolean());
        Directory.CreateDirectory(page.Scene);
        var said = await page.MessageAsync("scene", message => !message.GetProperty("isGone").GetBoolean());
        Assert.Equal("it is a folder, not a scene file", said.GetProperty("problems")[0].GetProperty("message").GetString());
        Directory.Delete(page.Scene);
        File.WriteAllText(page.Scene, Moved(9));
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    [Fact]
    public async Task AFolderThatMayNotBeEnteredForAWhileIsToldAndFollowedAgain()
    {
        Assert.SkipWhen(Here.ReadsEverything, "this user may read everything");
        await using var page = await LivePage.OpenAsync(mine: "closed/mine.png", prepare: Prepare, clock: new(DateTimeOffset.UtcNow));
        try
        {
            await page.ConnectAsync();
            const string Denied = "access is denied";
            await page.MessageAsync("comparison", message => $"{message.GetProperty("problem")}".Contains(Denied));
            File.WriteAllText(page.Scene, LivePage.Ball.Replace("\"models\": [", """
                "models": [ { "type": "mesh", "file": "closed/m.obj" },
                """));
            Assert.Contains(Denied, (await ProblemAsync()).GetProperty("message").GetString());
            Allow(page.Folder["closed"], true);
            await page.MessageAsync("scene", message => message.GetProperty("good").GetBoolean());
            Allow(page.Folder.Path, false);
            Assert.Contains(Denied, (await ProblemAsync()).GetProperty("message").GetString());
            Allow(page.Folder.Path, true);
            (await page.FrameAsync()).IsThatOf(page.Scene);
        }
        finally
        {
            Allow(page.Folder.Path, true);
            Allow(page.Folder["closed"], true);
        }

        async Task<JsonElement> ProblemAsync() => (await page.MessageAsync("scene", message => !message.GetProperty("good").GetBoolean()))
            .GetProperty("problems")[0];

        static void Prepare(TemporaryFolder folder)
        {
            Directory.CreateDirectory(folder["closed"]);
            folder.Write("closed/m.obj", "v 0 -1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n");
            Allow(folder["closed"], false);
        }

        static void Allow(string folder, bool isOpen)
        {
            if (!OperatingSystem.IsWindows()) File.SetUnixFileMode(folder, isOpen ? (UnixFileMode)0b111_000_000 : UnixFileMode.None);
        }
    }

    [Fact]
    public async Task ASavedMeshIsANewPicture()
    {
        const string Scene =
            """{ "camera": { "position": [3, 0, 0], "target": [0, 0, 0], "width": 20, "height": 20 }, """ +
            """ "models": [ { "type": "mesh", "file": "m.obj" } ] }""";
        await using var page = await LivePage.ShownAsync(Scene, prepare: folder => folder.Write("m.obj", "v 0 -1 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n"));
        page.Folder.Write("m.obj", "v 0 -1 0\nv 0 1 0\nv 0 0 -1\nf 1 2 3\n");
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    [Fact]
    public async Task AHugePictureIsShownSmallerAndAbandonedWhenTheSceneChanges()
    {
        await using var page = await LivePage.OpenAsync(
            LivePage.Ball.Replace("\"width\": 40, \"height\": 30", "\"width\": 10000, \"height\": 10000"));
        await page.ConnectAsync();
        var said = await page.MessageAsync("scene");
        Assert.True(said.GetProperty("shownWidth").GetInt32() * said.GetProperty("shownHeight").GetInt32() <= View.MaxPixels);
        File.WriteAllText(page.Scene, LivePage.Ball);
        while ((await page.FrameAsync()).Width != 40) ;
    }

    [Fact]
    public async Task AWatchedPictureIsComparedEachTimeItIsWritten()
    {
        await using var page = await LivePage.OpenAsync(
            mine: "mine.png", prepare: folder => PictureFile.Write(folder["mine.png"], new Picture(40, 30)));
        await page.ConnectAsync();
        var wrong = await page.MessageAsync("comparison", message => message.GetProperty("verdict").GetString() is not null);
        Assert.Equal("wrong", wrong.GetProperty("verdict").GetString());
        Assert.Equal(JsonValueKind.Array, wrong.GetProperty("middle").ValueKind);
        PictureFile.Write(page.Folder["mine.png"], ScalarRenderer.Render(SceneReader.Read(page.Scene).Scene!));
        await page.MessageAsync("comparison", message => message.GetProperty("verdict").GetString() == "identical");
    }

    [Fact(Skip = "links need rights there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public async Task ASceneThatIsALinkIsFollowedAndItsTargetWritten()
    {
        using var elsewhere = new TemporaryFolder();
        await using var page = await LivePage.ShownAsync(prepare: folder =>
            File.CreateSymbolicLink(folder["scene.json"], elsewhere.Write("real.json", LivePage.Ball)));
        File.WriteAllText(elsewhere["real.json"], Moved(9));
        var said = await page.MessageAsync("scene", message => message.GetProperty("version").GetInt32() > 1);
        (await page.FrameAsync()).IsThatOf(page.Scene);
        await page.AskAsync("""{"turn":[0.5,0.1],"rest":true}""");
        await page.MessageAsync("camera", message => message.GetProperty("moved").GetBoolean());
        await page.AskAsync($$"""{"write":{{said.GetProperty("version")}}}""");
        Assert.Equal("", (await page.MessageAsync("written")).GetProperty("problem").GetString());
        Assert.NotNull(File.ResolveLinkTarget(page.Scene, returnFinalTarget: false));
        Assert.NotEqual(Moved(9), File.ReadAllText(elsewhere["real.json"]));
    }

    [Fact(Skip = "no mkfifo there", SkipWhen = nameof(Here.IsWindows), SkipType = typeof(Here))]
    public async Task ASceneThatWasAPipeForAWhileIsFollowedAgain()
    {
        await using var page = await LivePage.ShownAsync();
        File.Delete(page.Scene);
        using (var mkfifo = Process.Start("mkfifo", [page.Scene])) await mkfifo.WaitForExitAsync();
        await page.MessageAsync("scene", message => !message.GetProperty("good").GetBoolean() && !message.GetProperty("isGone").GetBoolean());
        File.Delete(page.Scene);
        File.WriteAllText(page.Scene, Moved(9));
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    /// <summary>A save in the milliseconds before the replaced file is on the disk is not lost.</summary>
    [Fact]
    public void ASaveWhileTheCameraIsWrittenStays()
    {
        using var folder = new TemporaryFolder();
        var live = new LiveScene(folder.Write("scene.json", LivePage.Ball), TimeProvider.System, CancellationToken.None);
        File.WriteAllText(folder["scene.json"], Moved(9));
        var camera = live.State.Scene!.Camera with { Position = new(1, 2, 3) };
        Assert.Contains("changed at the same time", live.WriteCamera(camera, 1));
        Assert.Equal(Moved(9), File.ReadAllText(folder["scene.json"]));
        Assert.Equal(["scene.json"], folder.Names);
    }

    /// <summary>Saves a text as editors do. Between two steps less time passes than the server waits before it tells an error.</summary>
    private static void Save(LivePage page, string text, string how)
    {
        switch (how)
        {
            case "by rename":
                File.WriteAllText(page.Folder["new"], text);
                File.Move(page.Folder["new"], page.Scene, overwrite: true);
                return;
            case "in two steps":
                File.WriteAllText(page.Scene, text[..^20]);
                Pass(140);
                break;
            case "emptied first":
                File.WriteAllText(page.Scene, "");
                Pass(590);
                break;
            case "gone for a moment":
                File.Delete(page.Scene);
                Pass(590);
                break;
        }
        File.WriteAllText(page.Scene, text);

        void Pass(int milliseconds)
        {
            for (var i = 0; i < milliseconds; i += 10) page.Clock!.Advance(TimeSpan.FromMilliseconds(10));
        }
    }
}
