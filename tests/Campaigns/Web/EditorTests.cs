namespace RayCaster.Web.Tests;

/// <summary>The scene's text on the page: changed, opened, saved, and shared as a link that holds it.</summary>
[Collection("site")]
public class EditorTests(Chromium chromium, Site site)
{
    private const string Ball = """
        {
          // a ball; "ü" has two bytes, "😀" four
          "camera": { "position": [6, 0, 2.5], "target": [-6, 0, 0], "width": 40, "height": 30 },
          "models": [ { "type": "sphere", "name": "<img src=x onerror=alert(1)>", "center": [0, 0, 1], "radius": 1, "color": [1, 0.5, 0.1] } ]
        }
        """;

    [BrowserFact]
    public async Task TheEditorHoldsTheScenesTextAndAChangeIsDrawn()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        Assert.Equal(File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Trim(), (await web.Page.SceneTextAsync()).Trim());
        await web.Page.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task KeysThatAreTypedAreDrawn()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        await ShowBallAsync(web.Page);
        await web.Page.EvaluateExpressionAsync("""
            { const e = document.getElementById('scene-text'); e.focus(); e.selectionStart = e.selectionEnd = e.value.indexOf('40,') + 1; }
            """);
        await web.Page.PressAsync("Delete");
        await web.Page.Keyboard.TypeAsync("4");
        await web.Page.ShowsPictureOfAsync(Ball.Replace("40", "44"));
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task AnErrorIsToldWithItsPlaceAndGoesWithItsCorrection()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        await web.Page.WriteSceneAsync(Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await web.Page.SaysAsync("models[0].radius must be greater than 0");
        await web.Page.ClickOnAsync("aria/Go to line 4[role=\"button\"]");
        Assert.Equal(Ball.IndexOf("1, \"color\"", StringComparison.Ordinal), await web.Page.EvaluateExpressionAsync<int>(
            "document.activeElement.selectionStart"));
        Assert.DoesNotContain("VS Code", await web.Page.TextOfAsync("body"));
        await web.Page.WriteSceneAsync(Ball);
        await web.Page.HidesAsync("#problems");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task ASceneThatIsOpenedIsDrawnAndEdited()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        using var folder = new TemporaryFolder();
        await (await web.Page.ShowsAsync("#open-scene")).UploadFileAsync(folder.Write("ball.json", Ball));
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal(Ball, await web.Page.SceneTextAsync());
        await web.Page.SaysAsync("ball.json");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task TheTextIsSavedByteByByte()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        using var folder = new TemporaryFolder();
        var devTools = await web.Page.CreateCDPSessionAsync();
        await devTools.SendAsync("Page.setDownloadBehavior", new { behavior = "allow", downloadPath = folder.Path });
        await web.Page.WriteSceneAsync(Ball);
        await web.Page.ClickOnAsync("#save-scene");
        await Waiting.UntilAsync(() => folder.Names.Any(name => name.EndsWith(".json", StringComparison.Ordinal)));
        Assert.Equal(Ball, File.ReadAllText(folder[folder.Names.Single()]));
        Assert.Empty(web.Complaints);
    }

    /// <summary>The name of a model that looks like markup is text, like all the rest.</summary>
    [BrowserFact]
    public async Task ALinkHoldsTheSceneAndShowsItElsewhereAsText()
    {
        string link;
        await using (var web = await WebPage.OpenAsync(chromium, site))
        {
            await ShowBallAsync(web.Page);
            await web.Page.ClickOnAsync("#share-scene");
            await web.Page.WaitForFunctionAsync("() => /#scene=./.test(document.getElementById('share-link').value ?? '')");
            link = await web.Page.EvaluateExpressionAsync<string>("document.getElementById('share-link').value");
            Assert.StartsWith(web.Server.Address + "#scene=", link);
        }

        await using var other = await WebPage.OpenAsync(chromium, site, fragment: link[link.IndexOf('#')..]);
        await other.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal(Ball, await other.Page.SceneTextAsync());
        await other.Page.SaysAsync("<img src=x onerror=alert(1)>");
        Assert.Null(await other.Page.QuerySelectorAsync("img"));
        Assert.Empty(other.Complaints);
    }

    [BrowserFact]
    public async Task ALinkThatIsBrokenIsToldAndTheFirstSceneShown()
    {
        await using var web = await WebPage.OpenAsync(chromium, site, fragment: "#scene=%00<b>no");
        await web.Page.ShowsPictureOfAsync(SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!);
        await web.Page.WaitForFunctionAsync("() => /link/i.test(document.getElementById('scene-said').innerText)");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task TheCameraIsWrittenIntoTheText()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        await ShowBallAsync(web.Page);
        await web.Page.FocusAsync("#stage");
        await web.Page.PressAsync("ArrowLeft");
        await web.Page.ClickOnAsync("#camera-write:not([disabled])");
        await web.Page.WaitForFunctionAsync("text => document.getElementById('scene-text').value !== text", Ball);
        var text = await web.Page.SceneTextAsync();
        Assert.Contains("// a ball", text);
        await web.Page.ShowsPictureOfAsync(text);
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task TheTextIsThereAgainAfterThePageWasLoadedAgain()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        await ShowBallAsync(web.Page);
        await web.Page.ReloadAsync();
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal(Ball, await web.Page.SceneTextAsync());
        Assert.Empty(web.Complaints);
    }

    private static async Task ShowBallAsync(PuppeteerSharp.IPage page)
    {
        await page.WriteSceneAsync(Ball);
        await page.ShowsSizeAsync(40, 30);
    }
}
