using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>The page with a server: as any other, and what follows from its scene file.</summary>
[Collection("server")]
public class ServerTests(Chromium chromium) : PageTests
{
    private string Scene => ((ServedPage)Host).Scene;

    private protected override async Task<HostedPage> OpenAsync() => await ServedPage.OpenAsync(chromium);

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

    [BrowserFact]
    public async Task ASceneThatIsToldTwiceIsNotBeingDrawnForEver()
    {
        await using var host = await ServedPage.OpenAsync(chromium, script: """
            window.WebSocket = class extends WebSocket {
                addEventListener(type, listener) {
                    super.addEventListener(type, event => {
                        listener(event);
                        if (type === 'message' && /^{"kind":"scene"/.test(event.data)) listener(event);
                    });
                }
            };
            """);
        await host.WriteSceneAsync(Ball.Replace("\"width\": 40", "\"width\": 44"));
        await host.Page.SaysAsync("Up to date: 44");
        await host.Page.EvaluateExpressionAsync("new Promise(done => setTimeout(done, 400))"); // after any "Drawing …" that waits
        Assert.StartsWith("Up to date", await host.Page.TextOfAsync("#status"));
    }
}
