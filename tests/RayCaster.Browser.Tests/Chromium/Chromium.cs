namespace RayCaster.Browser.Tests;

/// <summary>One browser for all tests of a collection.</summary>
public sealed class Chromium : IAsyncLifetime
{
    public const string Program = "/usr/bin/chromium";

    private static readonly string[] flags =
    [
        "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
        "--disable-component-update", "--disable-sync", "--force-prefers-reduced-motion", "--disable-features=AutofillServerCommunication",
    ];

    private IBrowser? browser;

    public async ValueTask InitializeAsync()
    {
        if (File.Exists(Program)) browser = await Puppeteer.LaunchAsync(new() { ExecutablePath = Program, Args = flags });
    }

    /// <summary>A tab with a cache, a storage for times without a network and workers of its own.</summary>
    /// <param name="proxy">Where its requests go, also those for this machine; null for no such place.</param>
    /// <param name="script">What is done before any script of a page.</param>
    internal async Task<Tab> OpenAsync(string? proxy = null, string script = "")
    {
        var context = await browser!.CreateBrowserContextAsync(
            proxy is null ? null : new() { ProxyServer = proxy, ProxyBypassList = ["<-loopback>"] });
        return await OpenAsync(context, script, context.CloseAsync);
    }

    /// <summary>A tab beside those of other tests: it has only its session's storage for itself.</summary>
    internal Task<Tab> OpenAsUsualAsync(string script = "") => OpenAsync(browser!.DefaultContext, script, null);

    private static async Task<Tab> OpenAsync(IBrowserContext context, string script, Func<Task>? close)
    {
        var page = await context.NewPageAsync();
        await page.SetViewportAsync(new() { Width = 1300, Height = 900 });
        await page.EvaluateExpressionOnNewDocumentAsync(script);
        page.DefaultTimeout = 120_000; // beside other work
        return new(context, page, close ?? (() => page.CloseAsync()));
    }

    public async ValueTask DisposeAsync()
    {
        if (browser is not null) await browser.DisposeAsync();
    }
}

/// <summary>A tab of the browser.</summary>
internal sealed class Tab : IAsyncDisposable
{
    private readonly Func<Task> close;

    public Tab(IBrowserContext context, IPage page, Func<Task> close)
    {
        (Context, Page, this.close) = (context, page, close);
        page.Console += (_, e) => Complaints.Add(e.Message.Text);
        page.PageError += (_, e) => Complaints.Add(e.Message);
    }

    public IBrowserContext Context { get; }

    public IPage Page { get; }

    /// <summary>What the page has written to the console, and its errors.</summary>
    public List<string> Complaints { get; } = [];

    /// <summary>Opens a page of RayCaster and waits for its first picture.</summary>
    public async Task ShowAsync(string address)
    {
        await Page.GoToAsync(address);
        await Page.ShowsAsync("#picture[data-final=true]");
    }

    public async ValueTask DisposeAsync() => await close();
}
