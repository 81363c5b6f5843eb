// Makes the pictures of docs/live.md. With the name of a folder: pictures of both pages, wide and narrow, light and dark, to look at, there.
var room = File.ReadAllText(ProjectFolder.PathOf("scenes/room.json"));
await using var chromium = new Chromium();
await using var site = new Site();
await chromium.InitializeAsync();
await site.InitializeAsync();
if (args is [var looks])
{
    Directory.CreateDirectory(looks);
    foreach (var (name, open) in new (string, Func<Task<HostedPage>>)[] { ("server", ServedAsync), ("folder", FolderAsync) })
        foreach (var width in new[] { 1400, 360 })
            foreach (var scheme in new[] { "light", "dark" })
            {
                await using var host = await open();
                await SizeAsync(host.Page, width, scheme);
                await RestAsync(host); // the browser loads the page again for a phone
                await ShootAsync(host.Page, "start");
                await host.Page.ClickOnPixelAsync(325, 360, 500, 500);
                await ShootAsync(host.Page, "pixel");
                await host.Page.DropAsync(new Picture(500, 500));
                await host.Page.SaysAsync("mine.png is wrong");
                await ShootAsync(host.Page, "compared");
                await host.Page.ScreenshotAsync(Path.Combine(looks, $"{name}-{width}-{scheme}-whole.png"), new() { FullPage = true });

                Task ShootAsync(IPage page, string state) => page.ScreenshotAsync(Path.Combine(looks, $"{name}-{width}-{scheme}-{state}.png"));
            }
    return;
}

var docs = ProjectFolder.PathOf("docs");
await using (var served = await ServedAsync())
{
    await served.Page.ScreenshotAsync(Path.Combine(docs, "live.png"));
    await served.Page.ClickOnPixelAsync(325, 360, 500, 500);
    await (await served.Page.QuerySelectorAsync("#pixel")).ScreenshotAsync(Path.Combine(docs, "live-explain.png"));
}
await using (var web = await FolderAsync())
{
    await SizeAsync(web.Page, 1400, "light");
    await web.Page.ScreenshotAsync(Path.Combine(docs, "web.png"));
    await SizeAsync(web.Page, 360, "light");
    await RestAsync(web); // the browser loads the page again for a phone
    await web.Page.ScreenshotAsync(Path.Combine(docs, "web-phone.png"));
}

async Task<HostedPage> ServedAsync() => await RestAsync(await ServedPage.OpenAsync(chromium, room));

async Task<HostedPage> FolderAsync() => await RestAsync(await FolderPage.OpenAsync(chromium, site, ""));

// What the page tells last is how often each model shows.
async Task<HostedPage> RestAsync(HostedPage host)
{
    await host.Page.WaitForFunctionAsync("() => document.getElementById('model-0-rays')?.textContent.includes('%')");
    return host;
}

async Task SizeAsync(IPage page, int width, string scheme)
{
    var isPhone = width < 700;
    await page.SetViewportAsync(new() { Width = width, Height = isPhone ? 740 : 900, HasTouch = isPhone, IsMobile = isPhone });
    await page.EmulateMediaFeaturesAsync([new() { MediaFeature = MediaFeature.PrefersColorScheme, Value = scheme }]);
    await page.EvaluateExpressionAsync("scrollTo(0, 0)");
    await page.WaitForFunctionAsync("width => innerWidth === width", width);
}
