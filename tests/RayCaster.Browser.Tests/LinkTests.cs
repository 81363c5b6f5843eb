using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>A link shows its scene, or the page says that it shows another one.</summary>
[Collection("folder")]
public class LinkTests(Chromium chromium, Site site)
{
    private static readonly string code = FolderPage.Link(Ball)["#scene=".Length..];

    /// <summary>Mail programs and learning platforms encode a link, and add what follows it in a text.</summary>
    [BrowserTheory]
    [InlineData("#scene%3D", "")]
    [InlineData("%23scene=", "")]
    [InlineData("%23scene%3D", "")]
    [InlineData("%2523scene%253D", "")]
    [InlineData("#scene=", ".")]
    [InlineData("#scene=", ")")]
    [InlineData("#scene=", "&utm_source=mail")]
    [InlineData("#scene=", "%0D%0ASee you")]
    [InlineData("%23scene=", ">")]
    [InlineData("#scene=", "", "=%0D%0A")]
    public async Task ALinkThatOtherProgramsHaveChangedHoldsItsScene(string before, string after, string between = "") =>
        Assert.Equal(Ball, await TextOfAsync(before + code[..76] + between + code[76..] + after));

    [BrowserTheory]
    [InlineData("#scene")]
    [InlineData("#scene=")]
    [InlineData("#scene=%00<b>no")]
    [InlineData("#scene=c2hvcnQ")]
    [InlineData("%23scene=c2hvcnQ")]
    public async Task ALinkThatIsBrokenHoldsNone(string link) => Assert.Null(await TextOfAsync(link));

    /// <summary>To the host the link is the name of a file.</summary>
    [BrowserFact]
    public async Task AnEncodedLinkShowsItsSceneAtTheFirstVisit()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, "%23scene%3D" + code);
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal("", await web.Page.TextOfAsync("#notice"));
        Assert.Equal(web.Server.Address, web.Page.Url);
    }

    /// <summary>After a visit no request reaches the host.</summary>
    [BrowserFact]
    public async Task AnEncodedLinkShowsItsSceneAfterAVisit()
    {
        await using var web = await FolderPage.FirstVisitAsync(chromium, site, FolderPage.Link(Ball.Replace("40", "44")));
        await web.Page.EvaluateExpressionAsync("navigator.serviceWorker.ready.then(() => true)");
        await web.Page.GoToAsync($"{web.Server.Address}%23scene={code}");
        await web.Page.ShowsPictureOfAsync(Ball);
    }

    [BrowserFact]
    public async Task ALinkThatHoldsNoSceneIsTold()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, "#scene=c2hvcnQ");
        await web.Page.SaysAsync("This link is broken: it does not hold a whole scene. Another scene is shown.");
        await web.WriteSceneAsync(Ball);
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal("", await web.Page.TextOfAsync("#notice"));
    }

    [BrowserFact]
    public async Task AnAddressOfAPixelWithoutASceneIsTold()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, "#pixel=20,14");
        await web.Page.SaysAsync("This address holds a pixel but no scene: this is the page's first one.");
    }

    [BrowserFact]
    public async Task ALinkToAPixelHoldsTheSceneAndTheCamera()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.Page.FocusAsync("#stage");
        await web.Page.PressAsync("ArrowLeft");
        await web.Page.ShowsAsync("#camera-reset:not([disabled])");
        await web.Page.ClickOnPixelAsync(22, 14, 40, 30);
        await web.Page.ClickOnAsync("#pixel-link");
        var field = await web.Page.ShowsAsync("#pixel .link");
        var link = await field.EvaluateFunctionAsync<string>("field => field.value");

        await using var other = await FolderPage.OpenAsync(chromium, site, link[link.IndexOf('#')..] + ".");
        await other.Page.SaysAsync("Column 22, line 14");
        Assert.Equal(Ball, await other.SceneTextAsync());
        Assert.Equal(await web.Page.TextOfAsync("#camera-json"), await other.Page.TextOfAsync("#camera-json"));
        Assert.Equal(await web.Page.TextOfAsync("#pixel-head"), await other.Page.TextOfAsync("#pixel-head"));
    }

    [BrowserFact]
    public async Task ALinkThatWouldBeTooLongSaysSo()
    {
        var random = new Random(20261128);
        var text = Ball + "// " + string.Concat(Enumerable.Range(0, 12_000).Select(_ => (char)random.Next(33, 127)));
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.WriteSceneAsync(text);
        await web.Page.ShowsPictureOfAsync(Ball);
        await web.Page.ExplainAsync();
        foreach (var button in new[] { "#share-scene", "#pixel-link" })
        {
            await web.Page.ClickOnAsync(button);
            await web.Page.SaysAsync("many programs cut it. Save the scene as a file instead.");
            Assert.Null(await web.Page.QuerySelectorAsync(".link:not([hidden])"));
        }
    }

    /// <summary>The text that the page's own function finds in a link, without the page around it; null if there is none.</summary>
    private async Task<string?> TextOfAsync(string link)
    {
        await using var tab = await chromium.OpenAsUsualAsync();
        await tab.Page.GoToAsync((await site.ServeAsUsualAsync()).Address + "icon.svg");
        return await tab.Page.EvaluateFunctionAsync<string?>(
            "link => import('./link.js').then(page => page.isLink(link) ? page.fromLink(link) : null).then(found => found?.text ?? null)", link);
    }
}
