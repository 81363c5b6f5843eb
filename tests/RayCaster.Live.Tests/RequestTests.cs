namespace RayCaster.Live.Tests;

/// <summary>What pages ask for is answered.</summary>
public class RequestTests
{
    [Fact]
    public async Task TwentyPagesSeeTheSamePicture()
    {
        await using var page = await LivePage.OpenAsync();
        for (var i = 0; i < 19; i++) await page.ConnectAsync(); // each stays open and confirms no frame
        await page.ConnectAsync();
        (await page.FrameAsync()).IsThatOf(page.Scene);
    }

    [Fact]
    public async Task TheCameraIsWrittenIntoTheFileAndNothingElseChanges()
    {
        await using var page = await LivePage.ShownAsync();
        await page.AskAsync("""{"turn":[0.5,0.1],"rest":true}""");
        var camera = await page.MessageAsync("camera", message => message.GetProperty("moved").GetBoolean());
        await page.AskAsync("""{"write":1}""");
        Assert.Equal("", (await page.MessageAsync("written")).GetProperty("problem").GetString());
        var position = string.Join(", ", camera.GetProperty("position").EnumerateArray().Select(number => number.GetRawText()));
        Assert.Equal(LivePage.Ball.Replace("[6, 0, 2.5]", $"[{position}]"), File.ReadAllText(page.Scene));
        Assert.Equal(["scene.json"], page.Folder.Names);
    }

    [Fact]
    public async Task TheCameraIsNotWrittenOverAChangeThatThePageHasNotSeen()
    {
        await using var page = await LivePage.ShownAsync();
        await page.AskAsync("""{"turn":[0.5,0.1],"rest":true}""");
        await page.MessageAsync("camera", message => message.GetProperty("moved").GetBoolean());
        await page.AskAsync("""{"write":7}""");
        Assert.Contains("changed at the same time", (await page.MessageAsync("written")).GetProperty("problem").GetString());
        Assert.Equal(LivePage.Ball, File.ReadAllText(page.Scene));
    }

    [Fact]
    public async Task TheExplainedByteIsThePictures()
    {
        await using var page = await LivePage.OpenAsync();
        await page.ConnectAsync();
        var frame = await page.FrameAsync();
        var random = new Random(5);
        for (var i = 0; i < 30; i++)
        {
            var (column, line) = (random.Next(40), random.Next(30));
            await page.AskAsync($$"""{"explain":[{{column}},{{line}}]}""");
            var text = (await page.MessageAsync("explanation")).GetProperty("sections")[0].GetProperty("text").GetString();
            var (r, g, b) = frame[column, line];
            Assert.Contains($", bytes {r} {g} {b}\n", text);
        }
    }

    [Fact]
    public async Task ADiagnosisNamesNoOptionOfACommandForMoreHelp()
    {
        var upsideDown = ScalarRenderer.Render(SceneReader.Parse(Encoding.UTF8.GetBytes(LivePage.Ball), "", "").Scene!);
        Some.Flip(upsideDown);
        await using var page = await LivePage.OpenAsync(mine: "mine.png", prepare: folder => PictureFile.Write(folder["mine.png"], upsideDown));
        await page.ConnectAsync();
        await page.AskAsync("""{"diagnose":true}""");
        var text = (await page.MessageAsync("diagnosis")).GetProperty("text").GetString();
        Assert.Contains("Question: ", text);
        Assert.DoesNotContain("--hint", text);
    }

    /// <summary>The comparison, which comes first, may take seconds.</summary>
    [Fact]
    public async Task ADiagnosisThatIsCancelledBeforeItBeginsIsNotMade()
    {
        await using var page = await LivePage.OpenAsync(
            mine: "mine.png", prepare: folder => PictureFile.Write(folder["mine.png"], new Picture(40, 30)));
        await page.ConnectAsync();
        await page.AskAsync("""{"diagnose":true,"diagnose":false}""");
        Assert.Equal("The diagnosis was cancelled.", (await page.MessageAsync("diagnosis")).GetProperty("text").GetString());
    }

    /// <summary>The page has no commands: those of an answer are the console program's.</summary>
    [Fact]
    public async Task ADiagnosisNamesTheProgramOfItsCommands()
    {
        var noise = new Picture(40, 30);
        new Random(20261128).NextBytes(noise.Rgb);
        await using var page = await LivePage.OpenAsync(mine: "mine.png", prepare: folder => PictureFile.Write(folder["mine.png"], noise));
        await page.ConnectAsync();
        await page.AskAsync("""{"diagnose":true}""");
        var text = (await page.MessageAsync("diagnosis")).GetProperty("text").GetString();
        Assert.Contains("\"raycaster explain\"", text);
        Assert.DoesNotContain("\"explain\"", text);
    }

    [Fact]
    public async Task TheAnswerOfAnExplanationSaysWhatTheWatchedPictureHasThere()
    {
        await using var page = await LivePage.OpenAsync(
            mine: "mine.png", prepare: folder => PictureFile.Write(folder["mine.png"], new Picture(40, 30)));
        await page.ConnectAsync();
        await page.MessageAsync("comparison", message => message.GetProperty("verdict").GetString() == "wrong");
        await page.AskAsync("""{"explain":[20,14]}""");
        Assert.EndsWith("your picture has bytes 0 0 0 here\n", (await page.MessageAsync("explanation")).GetProperty("gist").GetString());
    }
}
