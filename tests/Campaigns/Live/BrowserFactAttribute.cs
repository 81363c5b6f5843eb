using PuppeteerSharp;

namespace RayCaster.Live.Tests;

/// <summary>A test that needs Chromium (Debian: apt-get install chromium). Without it the test is skipped, and the run says so.</summary>
public sealed class BrowserFactAttribute : FactAttribute
{
    public const string Path = "/usr/bin/chromium";

    public BrowserFactAttribute()
    {
        if (!File.Exists(Path)) Skip = "chromium is missing";
    }
}

/// <summary>The tests in a browser, which take turns with the one that there is.</summary>
[CollectionDefinition("browser")]
public class BrowserCollection : ICollectionFixture<Chromium>;

/// <summary>One browser for all tests.</summary>
public sealed class Chromium : IAsyncLifetime
{
    private static readonly string[] flags =
    [
        "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync",
    ];

    private IBrowser? browser;

    public async ValueTask InitializeAsync()
    {
        if (File.Exists(BrowserFactAttribute.Path))
            browser = await Puppeteer.LaunchAsync(new() { ExecutablePath = BrowserFactAttribute.Path, Args = flags });
    }

    internal Task<(IPage Page, List<string> Complaints)> OpenAsync(LivePage live, ViewPortOptions? size = null, bool isDark = false) =>
        OpenAsync(live.Server.Address, size, isDark);

    /// <summary>Opens the page and waits for its first picture. The list takes what the page writes to the console, and its errors.</summary>
    internal async Task<(IPage Page, List<string> Complaints)> OpenAsync(string address, ViewPortOptions? size = null, bool isDark = false)
    {
        var page = await browser!.NewPageAsync();
        await page.SetViewportAsync(size ?? new() { Width = 1300, Height = 900 });
        await page.EmulateMediaFeaturesAsync(
            [new() { MediaFeature = MediaFeature.PrefersColorScheme, Value = isDark ? "dark" : "light" }]);
        var complaints = new List<string>();
        page.Console += (_, e) => complaints.Add(e.Message.Text);
        page.PageError += (_, e) => complaints.Add(e.Message);
        page.DefaultTimeout = 60_000;
        await page.GoToAsync(address);
        await page.ShowsAsync("#picture[data-final=true]");
        return (page, complaints);
    }

    public async ValueTask DisposeAsync()
    {
        if (browser is not null) await browser.DisposeAsync();
    }
}

/// <summary>What a user waits for, reads and does.</summary>
internal static class PageExtensions
{
    extension(IPage page)
    {
        /// <summary>Waits until an element is visible.</summary>
        public Task<IElementHandle> ShowsAsync(string selector) => page.WaitForSelectorAsync(selector, new() { Visible = true });

        /// <summary>Waits until an element is not visible.</summary>
        public Task HidesAsync(string selector) => page.WaitForSelectorAsync(selector, new() { Hidden = true });

        /// <summary>Waits until the page shows a text.</summary>
        public Task SaysAsync(string text) => page.WaitForFunctionAsync("text => document.body.innerText.includes(text)", text);

        /// <summary>The text that an element shows.</summary>
        public Task<string> TextOfAsync(string selector) =>
            page.EvaluateFunctionAsync<string>("selector => document.querySelector(selector).innerText", selector);

        public async Task<BoundingBox> BoxOfAsync(string selector) => await (await page.ShowsAsync(selector)).BoundingBoxAsync();

        public Task PressAsync(string key) => page.Keyboard.PressAsync(key);

        /// <summary>Clicks on an element once it is visible.</summary>
        public async Task ClickOnAsync(string selector) => await (await page.ShowsAsync(selector)).ClickAsync();
    }
}
