using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>The page with a server: as any other, and what follows from its scene file.</summary>
[Collection("server")]
public class ServerTests(Chromium chromium) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync(string scene = Ball) => await ServedPage.OpenAsync(chromium, scene);

    [BrowserFact]
    public async Task TheSecretIsNotInTheAddressThatTheBrowserShows()
    {
        await using var served = await ServedPage.OpenAsync(chromium);
        Assert.DoesNotContain("token", served.Page.Url);
    }

    [BrowserFact]
    public async Task AnErrorHasALinkThatOpensVSCode()
    {
        await using var served = await ServedPage.OpenAsync(chromium);
        await served.WriteSceneAsync("{");
        var link = await served.Page.ShowsAsync("aria/Open in VS Code[role=\"link\"]");
        Assert.StartsWith("vscode://file/", await link.EvaluateFunctionAsync<string>("link => link.getAttribute('href')"));
    }

    [BrowserFact]
    public async Task ADeletedSceneIsGone()
    {
        await using var served = await ServedPage.OpenAsync(chromium);
        File.Delete(served.Scene);
        await served.Page.ShowsAsync("aria/The scene file is gone[role=\"heading\"]");
        Assert.Equal($"{served.Scene} is gone.", await served.Page.TextOfAsync("#status"));
        await served.WriteSceneAsync(Ball);
        await served.Page.HidesAsync("#problems");
        Assert.Empty(served.Complaints);
    }
}
