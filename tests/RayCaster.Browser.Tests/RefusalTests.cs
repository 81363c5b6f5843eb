using Microsoft.AspNetCore.Http;
using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>Browsers and hosts that lack something: the page says what, once, and it is true.</summary>
[Collection("folder")]
public class RefusalTests(Chromium chromium, Site site)
{
    private const string NothingIsKept = "() => navigator.serviceWorker.getRegistration().then(found => !found)";

    private const string NoPacking = "delete window.CompressionStream; delete window.DecompressionStream";

    [BrowserFact]
    public async Task AFrameWithoutAnOriginIsTold()
    {
        await using var server = await site.ServeAsync();
        await using var tab = await chromium.OpenAsync();
        await tab.Page.SetContentAsync($"<iframe sandbox=allow-scripts src={server.Address}></iframe>");
        await tab.Page.Frames[^1].SaysAsync($"This page stands in a frame that forbids it to work: open {server.Address} in a tab of its own.");
    }

    [BrowserFact]
    public async Task APageThatIsOpenedAsAFileIsTold()
    {
        await using var tab = await chromium.OpenAsync();
        await tab.Page.GoToAsync("file://" + site.Files().Single(file => file.EndsWith("/index.html", StringComparison.Ordinal)));
        await tab.Page.SaysAsync("This page was opened as a file: its folder has to be on a web server.");
    }

    [BrowserTheory]
    [InlineData("_framework", "more files. GitHub Pages leaves out _framework unless the file .nojekyll is beside it.")]
    [InlineData("_framework/dotnet.native.", "dotnet.native.", "GitHub")]
    [InlineData("worker.js", "This page is not complete: its host does not have worker.js.")]
    [InlineData("main.js", "This page is not complete: its host does not have main.js.")]
    [InlineData("dom.js", "This page is not complete: its host does not have dom.js.")]
    public Task WhatTheHostLacksIsNamedOnce(string missing, string told, string? untold = null) =>
        IsToldAsync(Missing(missing), told, untold);

    [BrowserTheory]
    [InlineData("main.js", "application/octet-stream", "main.js as application/octet-stream. Browsers run scripts as text/javascript only.")]
    [InlineData("_framework/dotnet.native.", "text/html", "as text/html. That is another page, perhaps for a login.")]
    public Task AFileOfAnotherTypeIsTold(string file, string type, string told) =>
        IsToldAsync(Sent(file, headers => headers.ContentType = type), told, "this browser");

    [BrowserTheory]
    [InlineData("sandbox allow-scripts", "its host's policy (Content-Security-Policy) must not have \"sandbox\".")]
    [InlineData("script-src 'self'", "its host's policy has to allow script-src 'self' 'wasm-unsafe-eval'.")]
    [InlineData("default-src 'self' 'unsafe-eval'; connect-src 'none'", "its host's policy has to allow connect-src 'self'.")]
    public Task AHostsPolicyIsTold(string policy, string told) =>
        IsToldAsync(Sent("", headers => headers.ContentSecurityPolicy = policy), told, "this browser");

    /// <summary>Where none of the page's scripts runs, its text names what the host and the browser may do.</summary>
    [BrowserTheory]
    [InlineData("text/javascript", "sandbox")]
    [InlineData("text/javascript", "script-src 'none'")]
    [InlineData("text/plain", "")]
    public async Task WithoutScriptsLoadingDoesNotStay(string type, string policy)
    {
        await using var server = await site.ServeAsync(oddity: Sent("", headers =>
        {
            (headers.ContentSecurityPolicy, headers.XContentTypeOptions) = (policy, "nosniff");
            if (headers.ContentType == "text/javascript") headers.ContentType = type;
        }));
        await using var tab = await chromium.OpenAsync();
        await tab.Page.GoToAsync(server.Address);
        Assert.Equal("Loading …", (await tab.Page.TextOfAsync("#status")).Trim());
        await tab.Page.EvaluateExpressionAsync("document.getAnimations().forEach(wait => wait.finish())");
        var told = await tab.Page.TextOfAsync("#status");
        foreach (var part in new[] { "text/javascript", "policy", "frame", "browser" }) Assert.Contains(part, told);
    }

    [BrowserFact]
    public async Task AnAddressWithoutTheLastSlashIsTold()
    {
        await using var server = await site.ServeAsync("/lab", (context, next) =>
        {
            if (context.Request.Path == "/lab") context.Request.Path = "/lab/index.html";
            return next();
        });
        await using var tab = await chromium.OpenAsync();
        await tab.Page.GoToAsync(server.Address[..^1]);
        await tab.Page.SaysAsync("This address lacks the page's other files. Has it to end with \"/\"?");
    }

    [BrowserFact]
    public async Task AHostThatRedirectsToTheIndexShowsThePageAtEachVisit()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, below: "/lab", oddity: (context, next) =>
        {
            if (context.Request.Path != "/lab/") return next();
            context.Response.Redirect("/lab/index.html");
            return Task.CompletedTask;
        });
        await web.Page.EvaluateExpressionAsync("navigator.serviceWorker.ready.then(() => true)");
        await web.Page.GoToAsync(web.Server.Address + "index.html");
        await web.Tab.ShowAsync(web.Server.Address);
    }

    /// <summary>An answer in place of a file is not kept either: none of that version is.</summary>
    [BrowserTheory]
    [InlineData(true)]
    [InlineData(false)]
    public async Task WithoutItsFirstSceneThePageDrawsAnother(bool isLogin)
    {
        var server = await site.ServeAsync(oddity: isLogin ? Sent("room.json", headers => headers.ContentType = "text/html") : Missing("room.json"));
        await using var web = new FolderPage(await chromium.OpenAsync(), server, isAlone: true);
        await web.Page.GoToAsync(server.Address);
        await web.Page.SaysAsync("its host does not have room.json");
        await web.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
        await web.Page.WaitForFunctionAsync(NothingIsKept);
    }

    [BrowserFact]
    public async Task ABrowserThatAllowsNoWorkerIsTold()
    {
        await using var server = await site.ServeAsync();
        await using var tab = await chromium.OpenAsync(script: "window.Worker = function () { throw new DOMException('workers are off'); }");
        await tab.Page.GoToAsync(server.Address);
        await tab.Page.SaysAsync("RayCaster cannot start in this browser: workers are off.");
    }

    /// <summary>Lockdown Mode of phones.</summary>
    [BrowserFact]
    public async Task ABrowserWithoutWebAssemblyIsTold()
    {
        await using var server = await site.ServeAsync(oddity: Before("worker.js", "delete self.WebAssembly;"));
        await using var tab = await chromium.OpenAsync();
        await tab.Page.GoToAsync(server.Address);
        await tab.Page.SaysAsync("RayCaster cannot start in this browser: it runs no WebAssembly, which a phone's Lockdown Mode turns off.");
    }

    /// <summary>Private windows, and disks that are full: the next visit is like the first one.</summary>
    [BrowserTheory]
    [InlineData("CacheStorage.prototype.open = () => Promise.reject(new DOMException('no', 'SecurityError'));")]
    [InlineData("Cache.prototype.put = () => Promise.reject(new DOMException('full', 'QuotaExceededError'));")]
    public async Task WithoutACacheThePageDraws(string refusal)
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, oddity: Before("offline.js", refusal));
        await web.Page.ShowsPictureOfAsync(Ball);
        await web.Page.WaitForFunctionAsync(NothingIsKept);
        Assert.Equal("", await web.Page.TextOfAsync("#notice"));
    }

    [BrowserTheory]
    [InlineData("Object.defineProperty(self, 'caches', { value: undefined });")]
    [InlineData("CacheStorage.prototype.match = () => Promise.reject(new DOMException('no', 'SecurityError'));")]
    public async Task WithoutWhatItHasKeptThePageDrawsEachTimeItIsLoaded(string refusal)
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, oddity: Before("offline.js", refusal));
        await web.Page.EvaluateExpressionAsync("navigator.serviceWorker.ready.then(() => true)");
        await web.Page.ReloadAsync();
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal("", await web.Page.TextOfAsync("#notice"));
    }

    [BrowserFact]
    public async Task ABrowserThatSavesNoFileSaysSo()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site,
            script: "URL.createObjectURL = () => { throw new DOMException('no', 'SecurityError'); }");
        await web.Page.ClickOnAsync("#save-scene");
        await web.Page.SaysAsync("The browser does not allow the page to save a file. The text is selected: copy it.");
        Assert.Equal(Ball, await web.Page.EvaluateExpressionAsync<string>("getSelection().toString()"));
        Assert.Empty(web.Complaints);
    }

    /// <summary>Without it GitHub Pages leaves out the folder _framework.</summary>
    [BrowserFact]
    public void TheSiteHoldsANojekyll() => Assert.Contains(site.Files(), file => Path.GetFileName(file) == ".nojekyll");

    [BrowserFact]
    public async Task ABrowserThatCannotPackSaysSoOfItsLinksAndOfThoseThatItOpens()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, script: NoPacking);
        var told = await web.Page.TextOfAsync("#notice");
        Assert.StartsWith("This browser cannot pack a scene into a link: Chrome and Edge can from version 103,", told);
        Assert.EndsWith("Another scene is shown.", told);
        await web.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
        await web.Page.ClickOnAsync("#share-scene");
        await web.Page.SaysAsync("Safari from 16.4. Save the scene as a file instead.");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task ASceneThatTheBrowserDidNotKeepIsToldWhenThePageIsLoadedAgain()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        var text = Ball.Replace("\"width\": 40", "\"width\": 44") + new string(' ', 1_000_000);
        await web.WriteSceneAsync(text);
        await web.Page.ShowsPictureOfAsync(text);
        await web.Page.ReloadAsync();
        await web.Page.SaysAsync("The browser could not keep shared.json: open it again. Another scene is shown.");
    }

    /// <summary>Whatever the page asks a browser for may be refused, full, or hold what another page has left there.</summary>
    [BrowserTheory]
    [InlineData(true, "Object.defineProperty(window, 'sessionStorage', { get() { throw new DOMException('no', 'SecurityError'); } })")]
    [InlineData(false, "Object.defineProperty(window, 'sessionStorage', { get() { throw new DOMException('no', 'SecurityError'); } })")]
    [InlineData(true, "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }")]
    [InlineData(false, "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); }")]
    [InlineData(true, "if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '{ \"rubbish')")]
    [InlineData(false, "if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '{ \"rubbish')")]
    [InlineData(true, "if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '[7]')")]
    [InlineData(false, "if (location.protocol !== 'about:') for (const name of ['scene', 'token']) sessionStorage.setItem(name, '[7]')")]
    [InlineData(true, "history.replaceState = () => { throw new DOMException('no', 'SecurityError'); }")]
    [InlineData(false, "history.replaceState = () => { throw new DOMException('no', 'SecurityError'); }")]
    [InlineData(true, "Object.defineProperty(navigator, 'clipboard', { value: undefined })")]
    [InlineData(true, "Object.defineProperty(navigator, 'clipboard', { value: { writeText: () => Promise.reject(new DOMException('no')) } })")]
    [InlineData(false, "Object.defineProperty(navigator, 'serviceWorker', { value: undefined })")]
    [InlineData(false, "Object.defineProperty(navigator, 'serviceWorker', { value: { register: () => Promise.reject(new DOMException('no')) } })")]
    public async Task ThePageWorksWithoutWhatABrowserMayRefuse(bool isServed, string script)
    {
        await using HostedPage host = isServed ? await ServedPage.OpenAsync(chromium, script: script)
            : await FolderPage.OpenAsync(chromium, site, script: script);
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

    /// <summary>The page says something once, does not try again, and does not say what is untrue.</summary>
    private async Task IsToldAsync(Oddity oddity, string told, string? untold)
    {
        await using var server = await site.ServeAsync(oddity: oddity);
        await using var tab = await chromium.OpenAsync(script: """
            window.made = window.later = 0;
            window.Worker = class extends Worker { constructor(...all) { super(...all); made++; } };
            const { setTimeout } = window;
            window.setTimeout = (...all) => { later++; return setTimeout(...all); };
            """);
        await tab.Page.GoToAsync(server.Address);
        await tab.Page.SaysAsync(told);
        if (untold is not null) Assert.DoesNotContain(untold, await tab.Page.TextOfAsync("header"));
        Assert.InRange(await tab.Page.EvaluateExpressionAsync<int>("made"), 0, 2);
        Assert.Equal(0, await tab.Page.EvaluateExpressionAsync<int>("later"));
    }

    private static bool Is(HttpContext context, string file) => context.Request.Path.Value!.StartsWith("/" + file, StringComparison.Ordinal);

    /// <summary>A host that does not have the files whose names begin so.</summary>
    private static Oddity Missing(string file) => (context, next) =>
    {
        if (Is(context, file)) context.Request.Path = "/missing";
        return next();
    };

    /// <summary>A host that sends the files whose names begin so with other headers.</summary>
    private static Oddity Sent(string file, Action<IHeaderDictionary> change) => (context, next) =>
    {
        if (Is(context, file)) context.Response.OnStarting(() => { change(context.Response.Headers); return Task.CompletedTask; });
        return next();
    };

    /// <summary>A script runs before one of the site's, which then runs as in a browser that refuses something.</summary>
    private Oddity Before(string file, string script) => async (context, next) =>
    {
        if (!Is(context, file))
        {
            await next();
            return;
        }
        context.Response.ContentType = "text/javascript";
        await context.Response.WriteAsync($"{script}\n{File.ReadAllText(site.Files().Single(path => Path.GetFileName(path) == file))}");
    };
}
