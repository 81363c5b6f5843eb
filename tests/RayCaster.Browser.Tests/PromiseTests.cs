using System.IO.Compression;
using System.Text.RegularExpressions;

namespace RayCaster.Browser.Tests;

/// <summary>What the page promises: it is for every screen, nothing leaves the browser, it works without a network, and no scene ends it.</summary>
[Collection("folder")]
public partial class PromiseTests(Chromium chromium, Site site)
{
    /// <summary>The file server is also the browser's proxy: no request of a page or of a worker escapes it.</summary>
    [BrowserFact]
    public async Task EachRequestIsForAFileOfTheSite()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, "", isProxied: true);
        var page = web.Page;
        await page.ExplainAsync();
        await page.DropWrongAsync(500, 500);
        await page.ClickOnAsync("#diagnose"); // in a worker of its own
        await page.SaysAsync("Cancel");
        await page.ClickOnAsync("#diagnose");
        Assert.All(web.Server.Requests, request => Assert.Matches($"^GET {web.Server.Root}/[\\w./-]* (200|304)$", request));

        // That another request would have been seen:
        await using var other = await web.Tab.Context.NewPageAsync();
        await other.EvaluateExpressionAsync("fetch('http://elsewhere.example/', { mode: 'no-cors' })");
        Assert.Contains(web.Server.Requests, request => request.StartsWith("GET http://elsewhere.example/", StringComparison.Ordinal));
    }

    [BrowserFact]
    public async Task ThePolicyOfThePageForbidsRequestsForOtherHosts()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, isProxied: true);
        var forbidden = await web.Page.EvaluateExpressionAsync<string[]>("""
            (async () => {
                const forbidden = [];
                addEventListener('securitypolicyviolation', event => forbidden.push(event.effectiveDirective));
                await fetch('http://elsewhere.example/fetched', { mode: 'no-cors' }).catch(() => {});
                for (const name of ['img', 'script', 'iframe']) {
                    const element = document.createElement(name);
                    const ended = new Promise(done => { element.onerror = element.onload = done; });
                    element.src = 'http://elsewhere.example/' + name;
                    document.body.append(element);
                    await ended;
                }
                return forbidden;
            })()
            """);
        Assert.Equal(["connect-src", "frame-src", "img-src", "script-src-elem"], forbidden.Order());
        Assert.DoesNotContain(web.Server.Requests, request => request.Contains("elsewhere", StringComparison.Ordinal));
    }

    [BrowserFact]
    public async Task AfterTheFirstVisitNoNetworkIsNeeded()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site);
        var page = web.Page;
        await page.EvaluateExpressionAsync("navigator.serviceWorker.ready.then(() => true)");
        await web.Server.DisposeAsync();
        await page.ReloadAsync();
        await page.ShowsAsync("#picture[data-final=true]");
        await page.ExplainAsync();
    }

    /// <summary>The page tells why it does not draw a text, and draws the next one.</summary>
    [BrowserFact]
    public async Task TextsThatAreNoSceneAreRefused()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        foreach (var (script, message) in new[]
        {
            ("'x'.repeat(10_000_000)", "1 error"),
            ("""'{"models":[' + '{},'.repeat(1_000_000) + ']}'""", " more"),
            ("""'{"models":' + '['.repeat(1_000_000)""", "nested deeper than 64"),
        })
        {
            await web.WriteSceneAsync(await web.Page.EvaluateExpressionAsync<string>(script));
            await web.Page.ShowsAsync("#problems");
            Assert.Contains(message, await web.Page.TextOfAsync("#status") + await web.Page.TextOfAsync("#problems"));
            await IsDrawnAsync(web);
        }
    }

    [BrowserFact]
    public async Task AFileOfAMillionModelsIsRefused()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        using var folder = new TemporaryFolder();
        var models = string.Concat(Enumerable.Repeat("""{"type":"sphere","center":[0,0,0],"radius":1},""", 1_000_000));
        await (await web.Page.ShowsAsync("#open-scene")).UploadFileAsync(folder.Write("big.json", $$"""{"models":[{{models}}]}"""));
        await web.Page.SaysAsync("big.json is too large: this page takes scenes of at most 10 MB.");
        await IsDrawnAsync(web);
    }

    [BrowserFact]
    public async Task TheFirstSceneIsTheRoomAndAFolderOfAHostWillDo()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, "", below: "/course/live");
        await web.Page.ShowsPictureOfAsync(SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!);
        Assert.Equal(File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Trim(), (await web.SceneTextAsync()).Trim());
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public void TheFirstVisitLoadsAsManyMegabytesAsTheDocsSay()
    {
        var files = site.Files().Where(file => Path.GetFileName(file) != "404.html").Select(File.ReadAllBytes).ToArray();
        var told = Visit().Match(File.ReadAllText(ProjectFolder.PathOf("docs/live.md")));
        Is("gzip", stream => new GZipStream(stream, CompressionLevel.Optimal));
        Is("plain", stream => stream);

        void Is(string host, Func<Stream, Stream> compress)
        {
            var sum = 0L;
            foreach (var file in files)
            {
                using var compressed = new MemoryStream();
                using (var stream = compress(compressed)) stream.Write(file);
                sum += compressed.ToArray().Length;
            }
            Assert.Equal((host, told.Groups[host].Value), (host, FormattableString.Invariant($"{sum / 1e6:0.0}")));
        }
    }

    [BrowserFact]
    public async Task FramesComeDuringADragAndTheCameraHasTurnedAfterIt()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, "");
        var page = web.Page;
        var before = await page.TextOfAsync("#camera-json");
        await DragAsync(page, frames: 3);
        Assert.Equal(0, await page.EvaluateExpressionAsync<int>("untrue"));
        await page.SaysAsync("Up to date");
        await page.ShowsAsync("#picture[data-final=true]");
        await page.WaitForFunctionAsync("before => document.getElementById('camera-json').innerText !== before", before);
        Assert.Empty(web.Complaints);
    }

    /// <summary>While a picture is drawn after a drag, which takes a worker about a second, the page draws on; if it drew the picture by itself, it
    /// would stand still.</summary>
    [BrowserFact]
    public async Task ThePageDoesNotStandStillWhileAPictureIsDrawn()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, "");
        await DragAsync(web.Page, frames: 1);
        var frames = await web.Page.EvaluateFunctionAsync<int>("""
            () => new Promise(done => {
                let frames = 0;
                requestAnimationFrame(function tick() {
                    frames++;
                    if (document.getElementById('picture').dataset.final === 'true') done(frames);
                    else requestAnimationFrame(tick);
                });
            })
            """);
        Assert.True(frames >= 5, $"{frames} frames only");
    }

    [BrowserFact]
    public async Task ALongDiagnosisShowsThatItRunsAndCanBeCancelled()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, "");
        var page = web.Page;
        var noise = new Picture(500, 500);
        new Random(20261127).NextBytes(noise.Rgb);
        await page.DropAsync(noise);
        await page.SaysAsync("mine.png is wrong");
        var workers = page.Workers.Length;
        await page.ClickOnAsync("#diagnose");
        await page.ShowsAsync("#diagnosing");
        Assert.Equal("Cancel", await page.TextOfAsync("#diagnose"));
        await page.ClickOnAsync("#diagnose");
        await page.HidesAsync("#diagnosing");
        Assert.Equal("The diagnosis was cancelled.", await page.TextOfAsync("#diagnosis-text"));
        Assert.Equal("Diagnose", await page.TextOfAsync("#diagnose"));
        await PageExtensions.UntilAsync(() => Task.FromResult(page.Workers.Length <= workers)); // nothing goes on searching
        Assert.Empty(web.Complaints);
    }

    private static async Task IsDrawnAsync(FolderPage web)
    {
        const string Next = """
            { "camera": { "position": [6, 0, 2.5], "target": [-6, 0, 0], "width": 44, "height": 30 },
              "models": [ { "type": "sphere", "center": [0, 0, 1], "radius": 1, "color": [1, 0.5, 0.1] } ] }
            """;
        await web.WriteSceneAsync(Next);
        await web.Page.ShowsPictureOfAsync(Next);
        await web.Page.HidesAsync("#problems");
        Assert.Equal("", await web.Page.TextOfAsync("#scene-said"));
        Assert.Empty(web.Complaints);
    }

    /// <summary>Drags until so many frames of a moving camera have come, and lets go.</summary>
    private static async Task DragAsync(IPage page, int frames)
    {
        await page.EvaluateExpressionAsync("""
            [window.moving, window.untrue] = [0, 0];
            document.getElementById('stage').addEventListener('frame', ({ detail: { isFinal, width } }) => {
                if (isFinal) return;
                moving++;
                if (width < 500 && document.getElementById('status').textContent.startsWith('Up to date')) untrue++;
            });
            """);
        var box = await page.BoxOfAsync("#picture");
        var (x, y) = (box.X + 100, box.Y + 100);
        await page.Mouse.MoveAsync(x, y);
        await page.Mouse.DownAsync();
        var step = 0;
        await PageExtensions.UntilAsync(async () =>
        {
            await page.Mouse.MoveAsync(x + ++step % 100, y + 30);
            return await page.EvaluateExpressionAsync<int>("moving") >= frames;
        });
        await page.Mouse.UpAsync();
    }

    [GeneratedRegex(@"loads (?<gzip>[\d.]+) MB if the host compresses, as most do, and (?<plain>[\d.]+) MB if it does not")]
    private static partial Regex Visit();
}
