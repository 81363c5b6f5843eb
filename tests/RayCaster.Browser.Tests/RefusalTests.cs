using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>Browsers and hosts that lack something: the page says what, once, and it is true.</summary>
[Collection("folder")]
public class RefusalTests(Chromium chromium, Site site)
{
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
    [InlineData("_framework/System.Linq", "System.Linq")]
    [InlineData("worker.js", "This page is not complete: its host does not have worker.js.")]
    [InlineData("main.js", "This page is not complete: its host does not have main.js.")]
    [InlineData("dom.js", "This page is not complete: its host does not have dom.js.")]
    public async Task WhatTheHostLacksIsNamedOnce(string missing, string told)
    {
        await using var server = await site.ServeAsync(missing: missing);
        await using var tab = await chromium.OpenAsync(script: """
            window.made = 0;
            window.Worker = class extends Worker { constructor(...all) { super(...all); made++; } }
            """);
        await tab.Page.GoToAsync(server.Address);
        await tab.Page.SaysAsync(told);
        await Task.Delay(1000); // the page tries again sooner, when it does
        Assert.InRange(await tab.Page.EvaluateExpressionAsync<int>("made"), 0, 2);
    }

    [BrowserFact]
    public async Task WithoutItsFirstSceneThePageDrawsAnother()
    {
        var server = await site.ServeAsync(missing: "room.json");
        await using var web = new FolderPage(await chromium.OpenAsync(), server);
        await web.Page.GoToAsync(server.Address);
        await web.Page.SaysAsync("its host does not have room.json");
        await web.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
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
        await using var server = await site.ServeAsync(refusal: ("worker.js", "delete self.WebAssembly;"));
        await using var tab = await chromium.OpenAsync();
        await tab.Page.GoToAsync(server.Address);
        await tab.Page.SaysAsync("RayCaster cannot start in this browser: it runs no WebAssembly, which a phone's Lockdown Mode turns off.");
    }

    /// <summary>Private windows, and disks that are full.</summary>
    [BrowserTheory]
    [InlineData("CacheStorage.prototype.open = () => Promise.reject(new DOMException('no', 'SecurityError'));")]
    [InlineData("CacheStorage.prototype.match = () => Promise.reject(new DOMException('no', 'SecurityError'));")]
    [InlineData("Cache.prototype.addAll = () => Promise.reject(new DOMException('full', 'QuotaExceededError'));")]
    [InlineData("Object.defineProperty(self, 'caches', { value: undefined });")]
    public async Task WithoutACacheThePageDrawsEachTimeItIsLoaded(string refusal)
    {
        var server = await site.ServeAsync(refusal: ("offline.js", refusal));
        await using var web = new FolderPage(await chromium.OpenAsync(), server);
        await web.Tab.ShowAsync(server.Address);
        await web.Page.WaitForFunctionAsync("""
            () => navigator.serviceWorker.getRegistration().then(found => !found || (!found.installing && !found.waiting))
            """);
        await web.Page.ReloadAsync();
        await web.Page.ShowsAsync("#picture[data-final=true]");
        await web.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal("", await web.Page.TextOfAsync("#notice"));
    }

    [BrowserFact]
    public async Task ABrowserThatSavesNoFileSaysSo()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, FolderPage.Link(Ball),
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
        await using var web = await FolderPage.OpenAsync(chromium, site, FolderPage.Link(Ball), script: NoPacking);
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
        await using var web = await FolderPage.OpenAsync(chromium, site, FolderPage.Link(Ball));
        var text = Ball.Replace("\"width\": 40", "\"width\": 44") + new string(' ', 1_000_000);
        await web.WriteSceneAsync(text);
        await web.Page.ShowsPictureOfAsync(text);
        await web.Page.ReloadAsync();
        await web.Page.SaysAsync("The browser could not keep shared.json: open it again. Another scene is shown.");
    }
}
