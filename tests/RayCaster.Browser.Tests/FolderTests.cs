namespace RayCaster.Browser.Tests;

/// <summary>The page without a server is as any other; what follows from its being a folder of files is in the other classes.</summary>
[Collection("folder")]
public class FolderTests(Chromium chromium, Site site) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync(string script) =>
        await FolderPage.OpenAsync(chromium, site, FolderPage.Link(HostedPage.Ball), script: script);

    private const string Rays = "() => document.getElementById('model-0-rays')?.textContent.includes('%')";

    [BrowserFact]
    public async Task AModelsRaysAreShownAlsoIfTheyAreCountedBeforeTheModelsAreTold()
    {
        await using var host = await OpenAsync("""
            const late = []; // what the first worker sends before the second one has counted the rays
            let made = 0;
            window.isHeld = false;
            window.Worker = class extends Worker {
                isFirst = made++ === 0;

                addEventListener(type, listener) {
                    super.addEventListener(type, event => {
                        if (type === 'message' && this.isFirst && isHeld) return void late.push(() => listener(event));
                        listener(event);
                        if (!isHeld || !String(event.data).includes('"ledger"')) return;
                        isHeld = false;
                        late.splice(0).forEach(tell => tell());
                    });
                }
            };
            """);
        await host.Page.WaitForFunctionAsync(Rays);
        await host.Page.EvaluateExpressionAsync("isHeld = true");
        await host.WriteSceneAsync(HostedPage.Ball.Replace("<img src=x onerror=alert(1)>", "other"));
        await host.Page.SaysAsync("other sphere");
        await host.Page.WaitForFunctionAsync(Rays);
    }
}
