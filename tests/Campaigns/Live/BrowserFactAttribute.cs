using Microsoft.Playwright;

namespace RayCaster.Live.Tests;

/// <summary>A test that needs Chromium. Without it the test is skipped, and the run says so.</summary>
public sealed class BrowserFactAttribute : FactAttribute
{
    public const string Path = "/usr/bin/chromium";

    public BrowserFactAttribute()
    {
        if (!File.Exists(Path)) Skip = $"there is no Chromium at {Path} (Debian: apt-get install chromium)";
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
        "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync",
    ];

    private IPlaywright? playwright;
    private IBrowser? browser;

    public async Task InitializeAsync()
    {
        if (!File.Exists(BrowserFactAttribute.Path)) return;
        playwright = await Playwright.CreateAsync();
        browser = await playwright.Chromium.LaunchAsync(new() { ExecutablePath = BrowserFactAttribute.Path, Args = flags });
    }

    internal Task<(IPage Page, List<string> Complaints)> OpenAsync(LivePage live, BrowserNewPageOptions? options = null) =>
        OpenAsync(live.Server.Address, options);

    /// <summary>Opens the page and waits for its first picture. The list takes what the page writes to the console, and its errors.</summary>
    internal async Task<(IPage Page, List<string> Complaints)> OpenAsync(string address, BrowserNewPageOptions? options = null)
    {
        var page = await browser!.NewPageAsync(options ?? new() { ViewportSize = new() { Width = 1300, Height = 900 } });
        var complaints = new List<string>();
        page.Console += (_, message) => complaints.Add(message.Text);
        page.PageError += (_, error) => complaints.Add(error);
        page.SetDefaultTimeout(60_000);
        await page.GotoAsync(address);
        await page.WaitForSelectorAsync("#picture[data-final=true]");
        return (page, complaints);
    }

    public async Task DisposeAsync()
    {
        if (browser is not null) await browser.DisposeAsync();
        playwright?.Dispose();
    }
}
