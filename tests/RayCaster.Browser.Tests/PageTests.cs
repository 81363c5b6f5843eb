using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>What the page does whichever host it comes from, used by mouse, by keyboard and by fingers.</summary>
[Trait("waits", "yes")]
public abstract class PageTests
{
    private const string Distance = """
        () => {
            const { position, target } = JSON.parse(`{${document.getElementById('camera-json').textContent}}`);
            return Math.hypot(...position.map((value, i) => value - target[i]));
        }
        """;

    /// <summary>Opens the page of a scene, in a tab of its own.</summary>
    private protected abstract Task<HostedPage> OpenAsync(string scene = Ball);

    [BrowserFact]
    public async Task EachByteOfThePictureIsTheDefinitionsAndThePageComplainsOfNothing()
    {
        await using var host = await OpenAsync();
        await host.Page.ShowsPictureOfAsync(Ball);
        await host.Page.SaysAsync("Up to date: 40 × 30 pixels, 1 model.");
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task ANameThatLooksLikeMarkupIsText()
    {
        await using var host = await OpenAsync();
        await host.Page.SaysAsync("<img src=x onerror=alert(1)>");
        Assert.Null(await host.Page.QuerySelectorAsync("img"));
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task AChangedSceneIsShownAndABrokenOneTold()
    {
        await using var host = await OpenAsync();
        await host.WriteSceneAsync(Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await host.Page.ShowsAsync("aria/The scene file has 1 error[role=\"heading\"]");
        Assert.Contains("models[0].radius must be greater than 0", await host.Page.TextOfAsync("#problem-list"));
        Assert.Contains("1 error in", await host.Page.TextOfAsync("#status"));
        var changed = Ball.Replace("1, 0.5, 0.1", "0.1, 0.5, 1");
        await host.WriteSceneAsync(changed);
        await host.Page.HidesAsync("#problems");
        await host.Page.ShowsPictureOfAsync(changed);
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task AClickExplainsThePixelInTheProgramsWordsAndArrowKeysStepOn()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        await page.ClickOnPixelAsync(20, 14, 40, 30);
        var sections = ExplanationText.Sections(new PixelExplanation(PageExtensions.Read(Ball), 20, 14), null);
        Assert.Contains("Column 20, line 14", await page.TextOfAsync("#pixel-head"));
        Assert.Equal(
            sections.Skip(1).Select(section => section.Text),
            await page.EvaluateExpressionAsync<string[]>("[...document.querySelectorAll('#pixel-explained pre')].map(pre => pre.textContent)"));
        Assert.EndsWith("#pixel=20,14", page.Url);
        Assert.NotNull(await page.QuerySelectorAsync(".section path.shape"));

        await page.PressAsync("ArrowRight");
        await page.SaysAsync("Column 21, line 14");
        await page.PressAsync("Escape");
        await page.HidesAsync("#pixel-explained");
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task InASmallerPictureTheNearestPixelIsExplained()
    {
        await using var host = await OpenAsync();
        await host.Page.EvaluateExpressionAsync("location.hash = '#pixel=20,14'");
        await host.Page.ShowsAsync("#pixel-head");
        await host.WriteSceneAsync(Ball.Replace("\"width\": 40", "\"width\": 10"));
        await host.Page.SaysAsync("Column 9, line 14");
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task APictureThatIsShownSmallerIsSaidToBe()
    {
        await using var host = await OpenAsync(Ball.Replace("\"width\": 40, \"height\": 30", "\"width\": 1, \"height\": 9000"));
        await host.Page.SaysAsync("1 × 9000 pixels, shown as 1 × 4500");
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task ADragTurnsTheCameraAndTheSceneTakesItOnlyWhenAsked()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        await page.ShowsAsync("#camera-json:not(:empty)");
        var before = await page.TextOfAsync("#camera-json");
        var box = await page.BoxOfAsync("#picture");
        await page.Mouse.MoveAsync(box.X + 100, box.Y + 100);
        await page.Mouse.DownAsync();
        await page.Mouse.MoveAsync(box.X + 200, box.Y + 130, new() { Steps = 10 });
        await page.Mouse.UpAsync();
        await page.ShowsAsync("#camera-write:not([disabled])");
        Assert.NotEqual(before, await page.TextOfAsync("#camera-json"));
        Assert.Equal(Ball, await host.SceneTextAsync());

        await page.ClickOnAsync("#camera-write");
        await page.SaysAsync("Written into the scene file.");
        await PageExtensions.UntilAsync(async () => await host.SceneTextAsync() != Ball);
        Assert.Contains("// a ball", await host.SceneTextAsync());
        await page.ShowsPictureOfAsync(await host.SceneTextAsync());
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task KeysAloneTurnTheCameraAndExplainAPixel()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        for (var i = 0; i < 40 && await FocusAsync() != "stage"; i++) await page.PressAsync("Tab");
        Assert.Equal("stage", await FocusAsync());
        await page.PressAsync("ArrowLeft");
        await page.ShowsAsync("#camera-reset:not([disabled])");
        await page.PressAsync("Enter");
        await page.SaysAsync("Column 20, line 15");
        Assert.Empty(host.Complaints);

        Task<string> FocusAsync() => page.EvaluateExpressionAsync<string>("document.activeElement.id");
    }

    [BrowserFact]
    public async Task EveryControlHasAName()
    {
        await using var host = await OpenAsync();
        await host.Page.ExplainAsync();
        await host.Page.DropAsync(new Picture(40, 30));
        await host.Page.SaysAsync("mine.png is wrong");
        Assert.Empty(await host.Page.EvaluateFunctionAsync<string[]>("""
            () => [...document.querySelectorAll('button, input, select, textarea, summary, a')].filter(e => e.checkVisibility())
                .filter(e => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby')
                    || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim())
                .map(e => e.outerHTML)
            """));
        Assert.Matches("The picture of .* 40 by 30 pixels", await host.Page.EvaluateFunctionAsync<string>(
            "() => document.querySelector('[role=img]').getAttribute('aria-label')"));
    }

    [BrowserFact]
    public async Task APictureThatIsChosenIsComparedAndItsWorstPlaceExplained()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        using var folder = new TemporaryFolder();
        await (await page.QuerySelectorAsync("#mine-file")).UploadFileAsync(folder.Write("mine.png", PageExtensions.Png(new(40, 30))));
        await page.ShowsAsync("#mine-worst:not([hidden])");
        Assert.Contains("mine.png is wrong", await page.TextOfAsync("#compare-text"));
        await page.SelectAsync("#mine-show", "difference");
        await page.ShowsAsync("#mine:not([hidden])");
        await page.ClickOnAsync("#mine-worst");
        await page.WaitForFunctionAsync("() => document.getElementById('pixel-explained').textContent.includes('It has 0 0 0 here: different')");
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task APictureThatIsDroppedIsCompared()
    {
        await using var host = await OpenAsync();
        await host.Page.DropAsync(ScalarRenderer.Render(PageExtensions.Read(Ball)), () => host.Page.ShowsAsync("body.dropping"));
        await host.Page.SaysAsync("mine.png is compared: identical.");
        Assert.Null(await host.Page.QuerySelectorAsync("body.dropping"));
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task AWrongPictureIsDiagnosed()
    {
        var room = File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Replace(": 500", ": 125");
        await using var host = await OpenAsync(room);
        await host.Page.DropAsync(MistakeCatalog.Draw(PageExtensions.Read(room), [MistakeCatalog.Named("nohalf")!]));
        await host.Page.SaysAsync("mine.png is wrong");
        await host.Page.SelectAsync("#hint", "answer");
        await host.Page.ClickOnAsync("#diagnose");
        await host.Page.HidesAsync("#diagnosing");
        Assert.Contains("nohalf", await host.Page.TextOfAsync("#diagnosis-text"));
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task NoWidthNeedsScrollingSidewaysAndTextHasContrastInLightAndDark()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        await page.ExplainAsync();
        await page.DropAsync(new Picture(40, 30));
        await page.SaysAsync("mine.png is wrong");
        foreach (var width in new[] { 360, 1400 })
        {
            foreach (var scheme in new[] { "light", "dark" })
            {
                await page.SetViewportAsync(new() { Width = width, Height = 800 });
                await page.EmulateMediaFeaturesAsync([new() { MediaFeature = MediaFeature.PrefersColorScheme, Value = scheme }]);
                await page.WaitForFunctionAsync("width => innerWidth === width", width);
                Assert.Equal((scheme, width), (scheme, await page.EvaluateExpressionAsync<int>(
                    "Math.max(innerWidth, document.documentElement.scrollWidth)")));
                Assert.Equal("", await page.FaintTextsAsync());
            }
        }
    }

    [BrowserFact]
    public async Task OneFingerTurnsTwoFingersMoveAndATapExplains()
    {
        await using var host = await OpenAsync();
        var page = host.Page;
        await page.SetViewportAsync(new() { Width = 360, Height = 740, HasTouch = true });
        var touch = await page.CreateCDPSessionAsync();
        await page.ShowsAsync("#camera-json:not(:empty)");
        var box = await page.BoxOfAsync("#picture");
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        var before = await page.EvaluateFunctionAsync<double>(Distance);

        await DragAsync([(x, y)], [(x + 60, y)]);
        await page.ShowsAsync("#camera-reset:not([disabled])");
        Assert.Equal(before, await page.EvaluateFunctionAsync<double>(Distance), tolerance: 1e-3);

        await DragAsync([(x - 20, y), (x + 20, y)], [(x - 80, y), (x + 80, y)]);
        await page.WaitForFunctionAsync($"before => ({Distance})() < 0.5 * before", before);

        await page.Touchscreen.TapAsync(x, y);
        await page.ShowsAsync("#pixel-head");
        Assert.Empty(host.Complaints);

        async Task DragAsync((decimal X, decimal Y)[] from, (decimal X, decimal Y)[] to)
        {
            await SendAsync("touchStart", from);
            for (var i = 1; i <= 10; i++)
                await SendAsync("touchMove", [.. from.Zip(to, (a, b) => (a.X + (b.X - a.X) * i / 10, a.Y + (b.Y - a.Y) * i / 10))]);
            await SendAsync("touchEnd", []);
        }

        Task SendAsync(string type, (decimal X, decimal Y)[] fingers) => touch.SendAsync("Input.dispatchTouchEvent", new
        {
            type,
            touchPoints = fingers.Select((finger, id) => new { x = finger.X, y = finger.Y, id }).ToArray(),
        });
    }
}
