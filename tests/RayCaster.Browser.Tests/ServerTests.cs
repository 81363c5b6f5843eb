using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>The page with a server: as any other, and what follows from its scene file.</summary>
[Collection("server")]
public class ServerTests(Chromium chromium) : PageTests
{
    private string Scene => ((ServedPage)Host).Scene;

    private protected override async Task<HostedPage> OpenAsync(string script) =>
        await ServedPage.OpenAsync(chromium, script: script);

    [BrowserFact]
    public void TheSecretIsNotInTheAddressThatTheBrowserShows() => Assert.DoesNotContain("token", Page.Url);

    [BrowserFact]
    public async Task AnErrorHasALinkThatOpensVSCode()
    {
        await Host.WriteSceneAsync("{");
        var link = await Page.ShowsAsync("aria/Open in VS Code[role=\"link\"]");
        Assert.StartsWith("vscode://file/", await link.EvaluateFunctionAsync<string>("link => link.getAttribute('href')"));
    }

    [BrowserFact]
    public async Task ADeletedSceneIsGone()
    {
        File.Delete(Scene);
        await Page.ShowsAsync("aria/The scene file is gone[role=\"heading\"]");
        Assert.Equal($"{Scene} is gone.", await Page.TextOfAsync("#status"));
        await Host.WriteSceneAsync(Ball);
        await Page.HidesAsync("#problems");
    }
}
