using PuppeteerSharp;

namespace RayCaster.Web.Tests;

/// <summary>What the page without a server can do as the one with a server can.</summary>
[Collection("site")]
public class PageTests(Chromium chromium, Site site)
{
    private static Scene Room { get; } = SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!;

    [BrowserFact]
    public async Task EachByteOfThePictureIsTheProgramsAndThePageComplainsOfNothing()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        Assert.Equal(ScalarRenderer.Render(Room).Rgb, await web.Page.BytesAsync());
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task AFolderOfAHostWillDo()
    {
        await using var web = await WebPage.OpenAsync(chromium, site, below: "/course/live");
        await web.Page.SaysAsync("Up to date: 500 × 500 pixels, 9 models.");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task FramesComeDuringADragAndTheCameraHasTurnedAfterIt()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        var before = await page.TextOfAsync("#camera-json");
        await DragAsync(page, frames: 3);
        await page.ShowsAsync("#picture[data-final=true]");
        await page.WaitForFunctionAsync("before => document.getElementById('camera-json').innerText !== before", before);
        Assert.Empty(web.Complaints);
    }

    /// <summary>The longest time in which the page draws nothing, while a picture is drawn after a drag. The worker needs more than a second for
    /// it; the page would stand still so long if it drew by itself.</summary>
    [BrowserFact]
    public async Task ThePageDoesNotStandStillWhileAPictureIsDrawn()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        await DragAsync(page, frames: 1);
        var times = await page.EvaluateFunctionAsync<double[]>("""
            () => new Promise(done => {
                const start = performance.now();
                let last = start, longest = 0;
                requestAnimationFrame(function tick() {
                    const now = performance.now();
                    longest = Math.max(longest, now - last);
                    last = now;
                    if (document.getElementById('picture').dataset.final === 'true') done([longest, now - start]);
                    else requestAnimationFrame(tick);
                });
            })
            """);
        Assert.True(times[0] < times[1] / 2, $"{times[0]:0} of {times[1]:0} ms without a frame");
    }

    [BrowserFact]
    public async Task AClickedPixelIsExplainedInTheProgramsWords()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        var box = await page.BoxOfAsync("#picture");
        await page.Mouse.ClickAsync(box.X + box.Width * 320.5m / 500, box.Y + box.Height * 360.5m / 500);
        await page.ShowsAsync("#pixel-head");
        var sections = ExplanationText.Sections(new PixelExplanation(Room, 320, 360), null);
        Assert.Contains("Column 320, line 360", await page.TextOfAsync("#pixel-head"));
        Assert.Equal(
            sections.Skip(1).Select(section => section.Text),
            await page.EvaluateExpressionAsync<string[]>("[...document.querySelectorAll('#pixel-explained pre')].map(pre => pre.textContent)"));
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task AWrongPictureThatIsDroppedIsDiagnosed()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        await page.DropAsync("mine.png", Png(MistakeCatalog.Draw(Room, [MistakeCatalog.Named("nohalf")!])));
        await page.SaysAsync("mine.png is wrong");
        await page.SelectAsync("#hint", "answer");
        await page.ClickOnAsync("#diagnose");
        await page.HidesAsync("#diagnosing");
        Assert.Contains("nohalf", await page.TextOfAsync("#diagnosis-text"));
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task ALongDiagnosisShowsThatItRunsAndCanBeCancelled()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        var noise = new Picture(500, 500);
        new Random(20261127).NextBytes(noise.Rgb);
        await page.DropAsync("noise.png", Png(noise));
        await page.SaysAsync("noise.png is wrong");
        var workers = page.Workers.Length;
        await page.ClickOnAsync("#diagnose");
        await page.ShowsAsync("#diagnosing");
        Assert.Equal("Cancel", await page.TextOfAsync("#diagnose"));
        await page.ClickOnAsync("#diagnose");
        await page.HidesAsync("#diagnosing");
        Assert.Equal("The diagnosis was cancelled.", await page.TextOfAsync("#diagnosis-text"));
        Assert.Equal("Diagnose", await page.TextOfAsync("#diagnose"));
        await Waiting.UntilAsync(() => page.Workers.Length <= workers); // nothing goes on searching
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task KeysAloneTurnTheCameraAndExplainAPixel()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        var page = web.Page;
        for (var i = 0; i < 40 && await FocusAsync() != "stage"; i++) await page.PressAsync("Tab");
        Assert.Equal("stage", await FocusAsync());
        await page.PressAsync("ArrowLeft");
        await page.ShowsAsync("#camera-reset:not([disabled])");
        await page.PressAsync("Enter");
        await page.ShowsAsync("#pixel-head");
        Assert.Contains("Column 250, line 250", await page.TextOfAsync("#pixel-head"));
        Assert.Empty(web.Complaints);

        Task<string> FocusAsync() => page.EvaluateExpressionAsync<string>("document.activeElement.id");
    }

    [BrowserFact]
    public async Task EveryControlHasAName()
    {
        await using var web = await WebPage.OpenAsync(chromium, site);
        Assert.Empty(await web.Page.EvaluateFunctionAsync<string[]>("""
            () => [...document.querySelectorAll('button, input, select, textarea, summary, a')].filter(e => e.checkVisibility())
                .filter(e => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby')
                    || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim())
                .map(e => e.outerHTML)
            """));
    }

    /// <summary>Makes the pictures of docs/live.md again if RAYCASTER_DOCS names their folder.</summary>
    [BrowserFact]
    public async Task ThePicturesOfTheDocsAreMade()
    {
        var folder = Environment.GetEnvironmentVariable("RAYCASTER_DOCS");
        await using var web = await WebPage.OpenAsync(chromium, site, size: new() { Width = 1400, Height = 900 });
        var page = web.Page;
        await page.WaitForFunctionAsync("() => document.getElementById('model-0-rays').textContent.includes('%')");
        if (folder is not null) await page.ScreenshotAsync(Path.Combine(folder, "web.png"));
        await page.SetViewportAsync(new() { Width = 360, Height = 740 });
        await page.EvaluateExpressionAsync("scrollTo(0, 0)");
        if (folder is not null) await page.ScreenshotAsync(Path.Combine(folder, "web-phone.png"));
        Assert.Empty(web.Complaints);
    }

    /// <summary>Drags until so many frames of a moving camera have come, and lets go.</summary>
    private static async Task DragAsync(IPage page, int frames)
    {
        await page.EvaluateExpressionAsync("""
            window.moving = 0;
            document.getElementById('stage').addEventListener('frame', event => { if (!event.detail.isFinal) moving++; });
            """);
        var box = await page.BoxOfAsync("#picture");
        var (x, y) = (box.X + 100, box.Y + 100);
        await page.Mouse.MoveAsync(x, y);
        await page.Mouse.DownAsync();
        var step = 0;
        await Waiting.UntilAsync(async () =>
        {
            await page.Mouse.MoveAsync(x + ++step % 100, y + 30);
            return await page.EvaluateExpressionAsync<int>("moving") >= frames;
        });
        await page.Mouse.UpAsync();
    }

    private static byte[] Png(Picture picture)
    {
        using var folder = new TemporaryFolder();
        PictureFile.Write(folder["mine.png"], picture);
        return File.ReadAllBytes(folder["mine.png"]);
    }
}
