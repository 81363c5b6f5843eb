using PuppeteerSharp;

namespace RayCaster.Live.Tests;

/// <summary>The page as a browser shows it, used by mouse and by keyboard.</summary>
[Collection("browser")]
public class BrowserTests(Chromium chromium)
{
    [BrowserFact]
    public async Task ThePictureIsTheDefinitionsAndThePageComplainsOfNothing()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        var right = ScalarRenderer.Render(SceneReader.Read(live.Scene).Scene!);
        foreach (var (x, y) in new[] { (0, 0), (20, 15), (39, 29), (12, 20) })
            Assert.Equal($"{right[x, y].R},{right[x, y].G},{right[x, y].B}", await PixelAsync(page, x, y));
        Assert.DoesNotContain("token", page.Url);
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task ASavedSceneIsShownAndABrokenOneTold()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        File.WriteAllText(live.Scene, LivePage.Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await page.ShowsAsync("aria/The scene file has 1 error[role=\"heading\"]");
        Assert.Contains("models[0].radius must be greater than 0", await page.TextOfAsync("#problem-list"));
        Assert.Contains("1 error in", await page.TextOfAsync("[role=status]"));
        Assert.StartsWith("vscode://file/", await HrefOfAsync(page, "Open in VS Code"));

        File.WriteAllText(live.Scene, LivePage.Ball.Replace("1, 0.5, 0.1", "0.1, 0.5, 1"));
        await page.HidesAsync("#problems");
        var right = ScalarRenderer.Render(SceneReader.Read(live.Scene).Scene!)[20, 14];
        await page.WaitForFunctionAsync("() => document.getElementById('picture').getContext('2d')." +
            $"getImageData(20, 14, 1, 1).data[2] === {right.B}");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task ADeletedSceneIsGone()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        File.Delete(live.Scene);
        await page.ShowsAsync("aria/The scene file is gone[role=\"heading\"]");
        Assert.Equal($"{live.Scene} is gone.", await page.TextOfAsync("[role=status]"));
        File.WriteAllText(live.Scene, LivePage.Ball);
        await page.HidesAsync("#problems");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task AClickExplainsThePixelAndArrowKeysStepOn()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        var box = await page.BoxOfAsync("#picture");
        await page.Mouse.ClickAsync(box.X + box.Width * 20.5m / 40, box.Y + box.Height * 14.5m / 30);
        await page.ShowsAsync("#pixel-head");
        Assert.Contains("Column 20, line 14", await page.TextOfAsync("#pixel-head"));
        Assert.Contains($", bytes {(await PixelAsync(page, 20, 14)).Replace(',', ' ')}\n", await page.TextOfAsync("#pixel-head") + "\n");
        Assert.EndsWith("#pixel=20,14", page.Url);
        Assert.Contains("t_ca = L · d", await page.TextOfAsync("#pixel-explained"));
        Assert.Contains("bias = 1e-6", await page.TextOfAsync("#pixel-explained")); // as "explain" writes it
        Assert.NotNull(await page.QuerySelectorAsync(".section path.shape"));

        await page.FocusAsync("#stage");
        await page.PressAsync("ArrowRight");
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-head').textContent.includes('Column 21, line 14')");
        await page.PressAsync("Escape");
        await page.HidesAsync("#pixel-explained");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task InASmallerPictureTheNearestPixelIsExplained()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        await page.EvaluateExpressionAsync("location.hash = '#pixel=20,14'");
        await page.ShowsAsync("#pixel-head");
        File.WriteAllText(live.Scene, LivePage.Ball.Replace("40", "10"));
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-head').textContent.includes('Column 9, line 14')");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task APictureThatIsShownSmallerIsSaidToBe()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        File.WriteAllText(live.Scene, LivePage.Ball.Replace("40", "1").Replace("30", "9000"));
        await page.WaitForFunctionAsync("() => document.getElementById('status').textContent.includes('1 × 9000 pixels, shown as 1 × 4500')");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task ADragTurnsTheCameraAndTheSceneFileTakesItOnlyWhenAsked()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        var before = await page.TextOfAsync("#camera-json");
        var box = await page.BoxOfAsync("#picture");
        await page.Mouse.MoveAsync(box.X + 100, box.Y + 100);
        await page.Mouse.DownAsync();
        await page.Mouse.MoveAsync(box.X + 200, box.Y + 130, new() { Steps = 10 });
        await page.Mouse.UpAsync();
        await page.ShowsAsync("#camera-write:not([disabled])");
        Assert.NotEqual(before, await page.TextOfAsync("#camera-json"));
        Assert.Equal(LivePage.Ball, File.ReadAllText(live.Scene));

        await page.ClickOnAsync("aria/Write into the scene file[role=\"button\"]");
        await page.SaysAsync("Written into the scene file.");
        Assert.Contains("// a ball", File.ReadAllText(live.Scene));
        Assert.NotEqual(LivePage.Ball, File.ReadAllText(live.Scene));
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task KeysAloneTurnTheCameraAndEveryControlHasAName()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        await page.FocusAsync("#stage");
        await page.PressAsync("ArrowLeft");
        await page.ShowsAsync("#camera-reset:not([disabled])");
        foreach (var control in await page.QuerySelectorAllAsync("button, input, select, summary, a"))
            Assert.NotEqual("", await control.EvaluateFunctionAsync<string>(
                "e => (e.getAttribute('aria-label') || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim()"));
        Assert.Matches("The picture of .* 40 by 30 pixels", await page.EvaluateFunctionAsync<string>(
            "() => document.querySelector('[role=img]').getAttribute('aria-label')"));
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task APictureOfOnesOwnIsComparedAndItsWorstPlaceExplained()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        PictureFile.Write(live.Folder["mine.png"], new Picture(40, 30));
        await (await page.QuerySelectorAsync("#mine-file")).UploadFileAsync(live.Folder["mine.png"]);
        await page.ShowsAsync("#mine-worst:not([hidden])");
        Assert.Contains("mine.png is wrong", await page.TextOfAsync("#compare-text"));
        await page.SelectAsync("#mine-show", "difference");
        await page.ShowsAsync("#mine:not([hidden])");
        await page.ClickOnAsync("#mine-worst");
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-explained').textContent.includes('It has 0 0 0 here: different')");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task APhonesWidthNeedsNoScrollingSideways()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live, new() { Width = 360, Height = 740 }, isDark: true);
        await page.FocusAsync("#stage");
        await page.PressAsync("Enter");
        await page.ShowsAsync("#pixel-head");
        Assert.True(await page.EvaluateFunctionAsync<int>("() => document.documentElement.scrollWidth") <= 360);
        Assert.Empty(complaints);
    }

    /// <summary>Makes the pictures of docs/live.md again if RAYCASTER_DOCS names their folder.</summary>
    [BrowserFact]
    public async Task ThePicturesOfTheDocsAreMade()
    {
        var folder = Environment.GetEnvironmentVariable("RAYCASTER_DOCS");
        await using var server = await LiveServer.StartAsync(ProjectFolder.PathOf("scenes/room.json"));
        var (page, complaints) = await chromium.OpenAsync(server.Address);
        await page.WaitForFunctionAsync("() => document.getElementById('model-0-rays').textContent.includes('%')");
        if (folder is not null) await page.ScreenshotAsync(Path.Combine(folder, "live.png"));
        var box = await page.BoxOfAsync("#picture");
        await page.Mouse.ClickAsync(box.X + box.Width * 0.65m, box.Y + box.Height * 0.72m);
        await page.ShowsAsync("#pixel-head");
        if (folder is not null) await (await page.QuerySelectorAsync("#pixel")).ScreenshotAsync(Path.Combine(folder, "live-explain.png"));
        Assert.Empty(complaints);
    }

    private static async Task<string> HrefOfAsync(IPage page, string link) =>
        await (await page.ShowsAsync($"aria/{link}[role=\"link\"]")).EvaluateFunctionAsync<string>("link => link.getAttribute('href')");

    private static Task<string> PixelAsync(IPage page, int x, int y) =>
        page.EvaluateFunctionAsync<string>(
            $"() => [...document.getElementById('picture').getContext('2d').getImageData({x}, {y}, 1, 1).data].slice(0, 3).join()");
}
