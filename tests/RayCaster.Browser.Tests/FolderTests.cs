namespace RayCaster.Browser.Tests;

/// <summary>The page without a server is as any other; what follows from its being a folder of files is in the other classes.</summary>
[Collection("folder")]
public class FolderTests(Chromium chromium, Site site) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync(string script) =>
        await FolderPage.OpenAsync(chromium, site, FolderPage.Link(HostedPage.Ball), script: script);

    [BrowserFact]
    public async Task AModelsRaysAreShownAlsoIfTheyAreCountedBeforeTheModelsAreTold()
    {
        await using var early = await OpenAsync("""
            const late = []; // what the first worker sends before the second one has counted the rays
            let made = 0, isCounted = false;
            window.Worker = class extends Worker {
                isFirst = made++ === 0;

                addEventListener(type, listener) {
                    super.addEventListener(type, event => {
                        if (type === 'message' && this.isFirst && !isCounted) return void late.push(() => listener(event));
                        listener(event);
                        if (!String(event.data).includes('"ledger"')) return;
                        isCounted = true;
                        late.splice(0).forEach(tell => tell());
                    });
                }
            };
            """);
        await early.Page.WaitForFunctionAsync("() => document.getElementById('model-0-rays')?.textContent.includes('%')");
    }
}
