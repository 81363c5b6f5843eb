namespace RayCaster.Browser.Tests;

/// <summary>What the page promises: it is for every screen, nothing leaves the browser, it works without a network, and no scene ends it.</summary>
[Collection("folder"), Trait("waits", "yes")]
public class PromiseTests(Chromium chromium, Site site)
{
    /// <summary>The file server is also the browser's proxy: no request of a page or of a worker escapes it.</summary>
    [BrowserFact]
    public async Task EachRequestIsForAFileOfTheSite()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, isProxied: true);
        var page = web.Page;
        await page.ExplainAsync();
        await page.DropAsync(new Picture(500, 500));
        await page.SaysAsync("mine.png is wrong");
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
        await using var web = await FolderPage.OpenAsync(chromium, site, isProxied: true);
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
        await using var web = await FolderPage.OpenAsync(chromium, site);
        var page = web.Page;
        await page.EvaluateExpressionAsync("navigator.serviceWorker.ready.then(() => true)");
        await web.Server.DisposeAsync();
        await page.ReloadAsync();
        await page.ShowsAsync("#picture[data-final=true]");
        await page.ExplainAsync();
    }

    [BrowserFact]
    public Task TenMegabytesThatAreNoSceneAreRefused() => IsRefusedAsync("'x'.repeat(10_000_000)", "1 error");

    [BrowserFact]
    public Task AMillionModelsWithoutATypeAreRefused() => IsRefusedAsync("""'{"models":[' + '{},'.repeat(1_000_000) + ']}'""", " more");

    [BrowserFact]
    public Task DeepNestingIsRefused() => IsRefusedAsync("""'{"models":' + '['.repeat(1_000_000)""", "nested deeper than 64");

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

    /// <summary>The page tells why it does not draw a text, and draws the next one.</summary>
    private async Task IsRefusedAsync(string script, string message)
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.WriteSceneAsync(await web.Page.EvaluateExpressionAsync<string>(script));
        await web.Page.ShowsAsync("#problems");
        Assert.Contains(message, await web.Page.TextOfAsync("#status") + await web.Page.TextOfAsync("#problems"));
        await IsDrawnAsync(web);
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
}
