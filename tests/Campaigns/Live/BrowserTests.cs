using Microsoft.Playwright;

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
        await page.GetByRole(AriaRole.Heading, new() { Name = "The scene file has 1 error" }).WaitForAsync();
        Assert.Contains("models[0].radius must be greater than 0", await page.InnerTextAsync("#problem-list"));
        Assert.Contains("1 error in", await page.GetByRole(AriaRole.Status).First.InnerTextAsync());
        Assert.StartsWith("vscode://file/", await page.GetByRole(AriaRole.Link, new() { Name = "Open in VS Code" }).GetAttributeAsync("href"));

        File.WriteAllText(live.Scene, LivePage.Ball.Replace("1, 0.5, 0.1", "0.1, 0.5, 1"));
        await page.WaitForSelectorAsync("#problems", new() { State = WaitForSelectorState.Hidden });
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
        await page.GetByRole(AriaRole.Heading, new() { Name = "The scene file is gone" }).WaitForAsync();
        Assert.Equal($"{live.Scene} is gone.", await page.GetByRole(AriaRole.Status).First.InnerTextAsync());
        File.WriteAllText(live.Scene, LivePage.Ball);
        await page.WaitForSelectorAsync("#problems", new() { State = WaitForSelectorState.Hidden });
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task IfAllModelsAreHiddenTheLedgerSaysSo()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        await page.ClickAsync("#ledger summary");
        await page.WaitForFunctionAsync("() => document.getElementById('ledger-report').textContent.includes('every model shows')");
        await page.ClickAsync("#model-0-hide");
        await page.WaitForFunctionAsync("() => document.getElementById('ledger-report').textContent === 'All models are hidden.'");
        await page.ClickAsync("#model-0-hide");
        await page.WaitForFunctionAsync("() => document.getElementById('ledger-report').textContent.includes('every model shows')");
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task AClickExplainsThePixelAndArrowKeysStepOn()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        var box = (await page.Locator("#picture").BoundingBoxAsync())!;
        await page.Mouse.ClickAsync(box.X + box.Width * 20.5f / 40, box.Y + box.Height * 14.5f / 30);
        await page.WaitForSelectorAsync("#pixel-bytes");
        Assert.Contains("column 20, line 14", await page.InnerTextAsync("#pixel-head"));
        Assert.Equal((await PixelAsync(page, 20, 14)).Replace(',', ' '), await page.InnerTextAsync("#pixel-bytes"));
        Assert.EndsWith("#pixel=20,14", page.Url);
        Assert.Contains("Sphere – Geometric Solution", await page.InnerTextAsync("#pixel-explained"));
        Assert.Contains("bias = 1e-6", await page.InnerTextAsync("#pixel-explained")); // as "explain" writes it
        Assert.True(await page.Locator(".section path.shape").CountAsync() > 0);

        await page.FocusAsync("#stage");
        await page.Keyboard.PressAsync("ArrowRight");
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-head').textContent.includes('column 21, line 14')");
        await page.Keyboard.PressAsync("Escape");
        await page.WaitForSelectorAsync("#pixel-explained", new() { State = WaitForSelectorState.Hidden });
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task InASmallerPictureTheNearestPixelIsExplained()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        await page.EvaluateAsync("location.hash = '#pixel=20,14'");
        await page.WaitForSelectorAsync("#pixel-bytes");
        File.WriteAllText(live.Scene, LivePage.Ball.Replace("40", "10"));
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-head').textContent.includes('column 9, line 14')");
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
        var before = await page.InnerTextAsync("#camera-json");
        var box = (await page.Locator("#picture").BoundingBoxAsync())!;
        await page.Mouse.MoveAsync(box.X + 100, box.Y + 100);
        await page.Mouse.DownAsync();
        await page.Mouse.MoveAsync(box.X + 200, box.Y + 130, new() { Steps = 10 });
        await page.Mouse.UpAsync();
        await page.WaitForSelectorAsync("#camera-write:not([disabled])");
        Assert.NotEqual(before, await page.InnerTextAsync("#camera-json"));
        Assert.Equal(LivePage.Ball, File.ReadAllText(live.Scene));

        await page.GetByRole(AriaRole.Button, new() { Name = "Write into the scene file" }).ClickAsync();
        await page.GetByText("Written into the scene file.").WaitForAsync();
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
        await page.Keyboard.PressAsync("ArrowLeft");
        await page.WaitForSelectorAsync("#camera-reset:not([disabled])");
        foreach (var control in await page.QuerySelectorAllAsync("button, input, select, summary, a"))
            Assert.NotEqual("", await control.EvaluateAsync<string>(
                "e => (e.getAttribute('aria-label') || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim()"));
        Assert.Contains(
            "40 by 30 pixels", await page.GetByRole(AriaRole.Img, new() { Name = "The picture of" }).First.GetAttributeAsync("aria-label"));
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task APictureOfOnesOwnIsComparedAndItsWorstPlaceExplained()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        PictureFile.Write(live.Folder["mine.png"], new Picture(40, 30));
        await page.SetInputFilesAsync("#mine-file", live.Folder["mine.png"]);
        await page.WaitForSelectorAsync("#mine-worst:not([hidden])");
        Assert.Contains("mine.png is wrong", await page.InnerTextAsync("#compare-text"));
        await page.SelectOptionAsync("#mine-show", "difference");
        await page.WaitForSelectorAsync("#mine:not([hidden])");
        await page.ClickAsync("#mine-worst");
        await page.WaitForSelectorAsync("#pixel-mine");
        Assert.Contains("bytes 0 0 0: different", await page.InnerTextAsync("#pixel-mine"));
        Assert.Empty(complaints);
    }

    [BrowserFact]
    public async Task APhonesWidthNeedsNoScrollingSideways()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(
            live, new() { ViewportSize = new() { Width = 360, Height = 740 }, ColorScheme = ColorScheme.Dark });
        await page.FocusAsync("#stage");
        await page.Keyboard.PressAsync("Enter");
        await page.WaitForSelectorAsync("#pixel-bytes");
        Assert.True(await page.EvaluateAsync<int>("() => document.documentElement.scrollWidth") <= 360);
        Assert.Empty(complaints);
    }

    /// <summary>Makes the pictures of docs/live.md again if RAYCASTER_DOCS names their folder.</summary>
    [BrowserFact]
    public async Task ThePicturesOfTheDocsAreMade()
    {
        var folder = Environment.GetEnvironmentVariable("RAYCASTER_DOCS");
        await using var server = await LiveServer.StartAsync(new(ProjectFolder.PathOf("scenes/room.json"), null, 0, false));
        var (page, complaints) = await chromium.OpenAsync(server.Address);
        await page.WaitForFunctionAsync("() => document.getElementById('model-0-rays').textContent.includes('%')");
        if (folder is not null) await page.ScreenshotAsync(new() { Path = Path.Combine(folder, "live.png") });
        var box = (await page.Locator("#picture").BoundingBoxAsync())!;
        await page.Mouse.ClickAsync(box.X + box.Width * 0.65f, box.Y + box.Height * 0.72f);
        await page.WaitForSelectorAsync("#pixel-bytes");
        if (folder is not null) await page.Locator("#pixel").ScreenshotAsync(new() { Path = Path.Combine(folder, "live-explain.png") });
        Assert.Empty(complaints);
    }

    private static Task<string> PixelAsync(IPage page, int x, int y) =>
        page.EvaluateAsync<string>(
            $"() => [...document.getElementById('picture').getContext('2d').getImageData({x}, {y}, 1, 1).data].slice(0, 3).join()");
}
