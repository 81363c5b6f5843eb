namespace RayCaster.Browser.Tests;

/// <summary>The page without a server is as any other; it has the most parts. What follows from its being a folder of files is in the
/// other classes.</summary>
[Collection("folder")]
public class FolderTests(Chromium chromium, Site site) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync() => await FolderPage.OpenAsync(chromium, site);

    [BrowserFact]
    public async Task EveryControlHasAName()
    {
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        Assert.Empty(await Page.EvaluateFunctionAsync<string[]>("""
            () => [...document.querySelectorAll('button, input, select, textarea, summary, a')].filter(e => e.checkVisibility())
                .filter(e => !(e.getAttribute('aria-label') || e.getAttribute('aria-labelledby')
                    || [...(e.labels ?? [])].map(l => l.textContent).join('') || e.textContent).trim())
                .map(e => e.outerHTML)
            """));
        Assert.Matches("The picture of .* 40 by 30 pixels", await Page.EvaluateFunctionAsync<string>(
            "() => document.querySelector('[role=img]').getAttribute('aria-label')"));
    }

    [BrowserFact]
    public async Task NoWidthNeedsScrollingSidewaysAndTextHasContrastInLightAndDark()
    {
        await Page.ExplainAsync();
        await Page.DropWrongAsync(40, 30);
        foreach (var width in new[] { 360, 1400 })
        {
            foreach (var scheme in new[] { "light", "dark" })
            {
                await Page.SetViewportAsync(new() { Width = width, Height = 800 });
                await Page.EmulateMediaFeaturesAsync([new() { MediaFeature = MediaFeature.PrefersColorScheme, Value = scheme }]);
                await Page.WaitForFunctionAsync("width => innerWidth === width", width);
                Assert.Equal((scheme, width), (scheme, await Page.EvaluateExpressionAsync<int>(
                    "Math.max(innerWidth, document.documentElement.scrollWidth)")));
                Assert.Equal("", await Page.FaintTextsAsync());
            }
        }
    }
}
