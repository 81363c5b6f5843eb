using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>What the page does whichever host it comes from, used by mouse, by keyboard and by fingers.</summary>
public abstract partial class PageTests : IAsyncLifetime
{
    private const string Distance = """
        () => {
            const { position, target } = JSON.parse(`{${document.getElementById('camera-json').textContent}}`);
            return Math.hypot(...position.map((value, i) => value - target[i]));
        }
        """;

    private protected HostedPage Host { get; private set; } = null!;

    private protected IPage Page => Host.Page;

    public async ValueTask InitializeAsync() => Host = await OpenAsync();

    public async ValueTask DisposeAsync()
    {
        if (Host is null) return; // it is skipped
        await Host.DisposeAsync();
        Assert.Empty(Host.Complaints);
    }

    /// <summary>Opens the page of the ball, in a tab of its own.</summary>
    /// <param name="script">What is done before any script of the page.</param>
    private protected abstract Task<HostedPage> OpenAsync(string script = "");

    [BrowserFact]
    public async Task EachByteOfThePictureIsTheDefinitionsAndThePageComplainsOfNothing()
    {
        await Page.ShowsPictureOfAsync(Ball);
        await Page.SaysAsync("Up to date: 40 × 30 pixels, 1 model.");
    }

    [BrowserFact]
    public async Task ANameThatLooksLikeMarkupIsText()
    {
        await Page.SaysAsync("<img src=x onerror=alert(1)>");
        Assert.Null(await Page.QuerySelectorAsync("img"));
    }

    [BrowserFact]
    public async Task AChangedSceneIsShownAndABrokenOneTold()
    {
        await Host.WriteSceneAsync(Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await Page.ShowsAsync("aria/The scene file has 1 error[role=\"heading\"]");
        Assert.Contains("models[0].radius must be greater than 0", await Page.TextOfAsync("#problem-list"));
        Assert.Contains("1 error in", await Page.TextOfAsync("#status"));
        var changed = Ball.Replace("1, 0.5, 0.1", "0.1, 0.5, 1");
        await Host.WriteSceneAsync(changed);
        await Page.HidesAsync("#problems");
        await Page.ShowsPictureOfAsync(changed);
    }

    [BrowserFact]
    public async Task AClickExplainsThePixelInTheProgramsWordsAndArrowKeysStepOn()
    {
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        var sections = ExplanationText.Sections(new PixelExplanation(PageExtensions.Read(Ball), 20, 14), null);
        Assert.Contains("Column 20, line 14", await Page.TextOfAsync("#pixel-head"));
        Assert.Equal(
            sections.Skip(1).Select(section => section.Text),
            await Page.EvaluateExpressionAsync<string[]>("""
                [...document.querySelectorAll('#pixel-parts pre')].map(pre => [...pre.children].map(line => line.textContent + '\n').join(''))
                """));
        Assert.EndsWith("#pixel=20,14", Page.Url);
        Assert.NotNull(await Page.QuerySelectorAsync(".section path.shape"));

        await Page.PressAsync("ArrowRight");
        await Page.SaysAsync("Column 21, line 14");
        await Page.PressAsync("Escape");
        await Page.HidesAsync("#pixel-explained");
    }

    [BrowserFact]
    public async Task InASmallerPictureTheNearestPixelIsExplained()
    {
        await Page.EvaluateExpressionAsync("location.hash = '#pixel=20,14'");
        await Page.ShowsAsync("#pixel-head");
        await Host.WriteSceneAsync(Ball.Replace("\"width\": 40", "\"width\": 10"));
        await Page.SaysAsync("Column 9, line 14");
    }

    [BrowserFact]
    public async Task APictureThatIsShownSmallerIsSaidToBe()
    {
        await Host.WriteSceneAsync(Ball.Replace("\"width\": 40, \"height\": 30", "\"width\": 1, \"height\": 9000"));
        await Page.SaysAsync("1 × 9000 pixels, shown as 1 × 4500");
    }

    [BrowserFact]
    public async Task ADragTurnsTheCameraAndTheSceneTakesItOnlyWhenAsked()
    {
        await Page.ShowsAsync("#camera-json:not(:empty)");
        var before = await Page.TextOfAsync("#camera-json");
        var box = await Page.BoxOfAsync("#picture");
        await Page.Mouse.MoveAsync(box.X + 100, box.Y + 100);
        await Page.Mouse.DownAsync();
        await Page.Mouse.MoveAsync(box.X + 200, box.Y + 130, new() { Steps = 10 });
        await Page.Mouse.UpAsync();
        await Page.ShowsAsync("#camera-write:not([disabled])");
        Assert.NotEqual(before, await Page.TextOfAsync("#camera-json"));
        Assert.Equal(Ball, await Host.SceneTextAsync());

        await Page.ClickOnAsync("#camera-write");
        await Page.SaysAsync("Written into the scene file.");
        await PageExtensions.UntilAsync(async () => await Host.SceneTextAsync() != Ball);
        Assert.Contains("// a ball", await Host.SceneTextAsync());
        await Page.ShowsPictureOfAsync(await Host.SceneTextAsync());
    }

    [BrowserFact]
    public async Task KeysAloneTurnTheCameraAndExplainAPixel()
    {
        for (var i = 0; i < 40 && await FocusAsync() != "stage"; i++) await Page.PressAsync("Tab");
        Assert.Equal("stage", await FocusAsync());
        await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        await Page.PressAsync("Enter");
        await Page.SaysAsync("Column 20, line 15");
        Assert.Empty(Host.Complaints);

        Task<string> FocusAsync() => Page.EvaluateExpressionAsync<string>("document.activeElement.id");
    }

    [BrowserFact]
    public async Task EveryControlHasAName()
    {
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        Assert.Empty(await Page.EvaluateFunctionAsync<string[]>("""
            () => [...document.querySelectorAll('button, input, select, textarea, summary, a')].filter(e => e.checkVisibility())
                .filter(e => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby')
                    || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim())
                .map(e => e.outerHTML)
            """));
        Assert.Matches("The picture of .* 40 by 30 pixels", await Page.EvaluateFunctionAsync<string>(
            "() => document.querySelector('[role=img]').getAttribute('aria-label')"));
    }

    [BrowserFact]
    public async Task APictureThatIsChosenIsComparedAndItsWorstPlaceExplained()
    {
        using var folder = new TemporaryFolder();
        await (await Page.QuerySelectorAsync("#mine-file")).UploadFileAsync(folder.Write("mine.png", PageExtensions.Png(new(40, 30))));
        await Page.ShowsAsync("#mine-worst:not([hidden])");
        await Page.SaysAsync("mine.png is wrong");
        await Page.SelectAsync("#mine-show", "difference");
        await Page.ShowsAsync("#mine:not([hidden])");
        await Page.ClickOnAsync("#mine-worst");
        await Page.WaitForFunctionAsync("() => document.getElementById('pixel-explained').textContent.includes('It has 0 0 0 here: different')");
    }

    [BrowserFact]
    public async Task APictureThatIsDroppedIsCompared()
    {
        await Page.DropAsync(ScalarRenderer.Render(PageExtensions.Read(Ball)), () => Page.ShowsAsync("body.dropping"));
        await Page.SaysAsync("mine.png is compared: identical.");
        Assert.Null(await Page.QuerySelectorAsync("body.dropping"));
    }

    /// <summary>What is wrong takes a browser seconds to find; the verdict and the difference do not wait for it.</summary>
    [BrowserFact]
    public async Task TheVerdictOnAPictureComesBeforeItsCauses()
    {
        await Page.EvaluateExpressionAsync("""
            {
                const text = document.getElementById('compare-text'), said = document.getElementById('mine-said');
                window.seen = [];
                new MutationObserver(() => seen.push(`${said.textContent} ${text.textContent.slice(0, 24)}`)).observe(text, { childList: true });
            }
            """);
        await Page.DropWrongAsync(40, 30);
        var seen = await Page.EvaluateExpressionAsync<string[]>("seen.filter(said => said.trim() !== '')");
        Assert.StartsWith("mine.png is compared: wrong. Looking for what is", seen[0]);
        Assert.StartsWith("mine.png is compared: wrong. mine.png is wrong:", seen[^1]);
    }

    [BrowserFact]
    public async Task AWrongPictureIsDiagnosed()
    {
        var room = File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Replace(": 500", ": 125");
        await Host.WriteSceneAsync(room);
        await Page.ShowsPictureOfAsync(room);
        await Page.DropAsync(MistakeCatalog.Draw(PageExtensions.Read(room), [MistakeCatalog.Named("nohalf")!.Usual]));
        await Page.SaysAsync("mine.png is wrong");
        await Page.SelectAsync("#hint", "answer");
        await Page.ClickOnAsync("#diagnose");
        await Page.HidesAsync("#diagnosing");
        Assert.Contains("nohalf", await Page.TextOfAsync("#diagnosis-text"));
    }

    /// <summary>Whatever the page asks a browser for may be refused, full, or hold what another page has left there.</summary>
    [BrowserTheory]
    [InlineData("Object.defineProperty(window, 'sessionStorage', { get() { throw new DOMException('no', 'SecurityError'); } })")]
    [InlineData("Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }")]
    [InlineData("if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '{ \"rubbish')")]
    [InlineData("if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '[7]')")]
    [InlineData("history.replaceState = () => { throw new DOMException('no', 'SecurityError'); }")]
    [InlineData("Object.defineProperty(navigator, 'clipboard', { value: undefined })")]
    [InlineData("Object.defineProperty(navigator, 'clipboard', { value: { writeText: () => Promise.reject(new DOMException('no')) } })")]
    [InlineData("Object.defineProperty(navigator, 'serviceWorker', { value: undefined })")]
    [InlineData("Object.defineProperty(navigator, 'serviceWorker', { value: { register: () => Promise.reject(new DOMException('no')) } })")]
    public async Task ThePageWorksWithoutWhatABrowserMayRefuse(string script)
    {
        await using var host = await OpenAsync(script);
        await host.Page.ShowsPictureOfAsync(Ball);
        await host.Page.ExplainAsync();
        await host.Page.ClickOnAsync("#camera-copy");
        await host.Page.WaitForFunctionAsync("() => document.getElementById('camera-said').textContent");
        await host.Page.DropWrongAsync(40, 30);
        var changed = Ball.Replace("\"width\": 40", "\"width\": 44");
        await host.WriteSceneAsync(changed);
        await host.Page.ShowsPictureOfAsync(changed);
        Assert.Empty(host.Complaints);
    }

    [BrowserFact]
    public async Task ThePixelUnderThePointerIsToldAgainAfterTheCameraHasTurned()
    {
        await Page.HoverOnPixelAsync(20, 14, 40, 30);
        await Page.SaysAsync("column 20, line 14 (row 15): <img");
        await Page.FocusAsync("#stage");
        for (var i = 0; i < 8; i++) await Page.PressAsync("ArrowLeft");
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        await Page.SaysAsync("column 20, line 14 (row 15): the background");
    }

    [BrowserFact]
    public async Task WhatIsChosenIsNotContradicted()
    {
        await Page.DropWrongAsync(40, 30);
        Assert.Equal(0, await Page.EvaluateExpressionAsync<int>(
            "[...document.querySelectorAll('input[type=file]')].filter(e => getComputedStyle(e).opacity > 0).length")); // "No file chosen"
    }

    [BrowserFact]
    public async Task NoWidthNeedsScrollingSidewaysAndTextHasContrastInLightAndDark()
    {
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        foreach (var width in new[] { 360, 1400 })
        {
            foreach (var scheme in new[] { "light", "dark" })
            {
                await Page.SetViewportAsync(new() { Width = width, Height = 800 });
                await Page.EmulateMediaFeaturesAsync([new() { MediaFeature = MediaFeature.PrefersColorScheme, Value = scheme }]);
                await Page.WaitForFunctionAsync("width => innerWidth === width", width);
                Assert.Equal((scheme, width), (scheme, await Page.EvaluateExpressionAsync<int>(
                    "Math.max(innerWidth, document.documentElement.scrollWidth)")));
                Assert.Equal("", await Page.FaintTextsAsync());
            }
        }
    }

    [BrowserFact]
    public async Task OneFingerTurnsTwoFingersMoveAndATapExplains()
    {
        await Page.SetViewportAsync(new() { Width = 360, Height = 740, HasTouch = true });
        var touch = await Page.CreateCDPSessionAsync();
        await Page.ShowsAsync("#camera-json:not(:empty)");
        var box = await Page.BoxOfAsync("#picture");
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        var before = await Page.EvaluateFunctionAsync<double>(Distance);

        await DragAsync([(x, y)], [(x + 60, y)]);
        await Page.ShowsAsync("#camera-reset:not([disabled])");
        Assert.Equal(before, await Page.EvaluateFunctionAsync<double>(Distance), tolerance: 1e-3);

        await DragAsync([(x - 20, y), (x + 20, y)], [(x - 80, y), (x + 80, y)]);
        await Page.WaitForFunctionAsync($"before => ({Distance})() < 0.5 * before", before);

        await Page.Touchscreen.TapAsync(x, y);
        await Page.ShowsAsync("#pixel-head");
        Assert.Empty(Host.Complaints);

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
