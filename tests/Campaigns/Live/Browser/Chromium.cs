using PuppeteerSharp;

namespace RayCaster.Live.Tests;

/// <summary>One browser for all tests.</summary>
public sealed class Chromium : IAsyncLifetime
{
    private static readonly string[] flags =
    [
        "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--disable-features=AutofillServerCommunication",
    ];

    private IBrowser? browser;

    public async ValueTask InitializeAsync()
    {
        if (File.Exists(BrowserFactAttribute.Path))
            browser = await Puppeteer.LaunchAsync(new() { ExecutablePath = BrowserFactAttribute.Path, Args = flags });
    }

    /// <summary>Pages with a cache and with workers of their own, without those of other tests.</summary>
    /// <param name="proxy">Where their requests go, also those for this machine; null for no such place.</param>
    internal Task<IBrowserContext> AloneAsync(string? proxy = null) =>
        browser!.CreateBrowserContextAsync(proxy is null ? null : new() { ProxyServer = proxy, ProxyBypassList = ["<-loopback>"] });

    /// <summary>Opens the page and waits for its first picture. The list takes what the page writes to the console, and its errors.</summary>
    internal async Task<(IPage Page, List<string> Complaints)> OpenAsync(
        string address, ViewPortOptions? size = null, bool isDark = false, IBrowserContext? alone = null)
    {
        var page = await (alone?.NewPageAsync() ?? browser!.NewPageAsync());
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
