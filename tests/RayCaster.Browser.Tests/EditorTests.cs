using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>The scene's text on the page: changed, opened, saved, and shared as a link that holds it.</summary>
[Collection("folder")]
public class EditorTests(Chromium chromium, Site site)
{
    [BrowserFact]
    public async Task KeysThatAreTypedAreDrawn()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.Page.EvaluateExpressionAsync("""
            { const e = document.getElementById('scene-text'); e.focus(); e.selectionStart = e.selectionEnd = e.value.indexOf('40,') + 1; }
            """);
        await web.Page.PressAsync("Delete");
        await web.Page.Keyboard.TypeAsync("4");
        await web.Page.ShowsPictureOfAsync(Ball.Replace("40", "44"));
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task AnErrorIsToldWithItsPlaceAndGoesWithItsCorrection()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.WriteSceneAsync(Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await web.Page.SaysAsync("models[0].radius must be greater than 0");
        await web.Page.ClickOnAsync("aria/Go to line 4[role=\"button\"]");
        Assert.Equal(Ball.IndexOf("1, \"color\"", StringComparison.Ordinal), await web.Page.EvaluateExpressionAsync<int>(
            "document.activeElement.selectionStart"));
        Assert.DoesNotContain("VS Code", await web.Page.TextOfAsync("body"));
        await web.WriteSceneAsync(Ball);
        await web.Page.HidesAsync("#problems");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task ASceneThatIsOpenedIsDrawnAndEdited()
    {
        var other = Ball.Replace("40", "44");
        await using var web = await FolderPage.OpenAsync(chromium, site);
        using var folder = new TemporaryFolder();
        await (await web.Page.ShowsAsync("#open-scene")).UploadFileAsync(folder.Write("ball.json", other));
        await web.Page.ShowsPictureOfAsync(other);
        Assert.Equal(other, await web.SceneTextAsync());
        await web.Page.SaysAsync("ball.json");
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task TheTextIsSavedByteByByte()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        using var folder = new TemporaryFolder();
        var devTools = await web.Page.CreateCDPSessionAsync();
        await devTools.SendAsync("Page.setDownloadBehavior", new { behavior = "allow", downloadPath = folder.Path });
        await web.WriteSceneAsync(Ball);
        await web.Page.ClickOnAsync("#save-scene");
        await PageExtensions.UntilAsync(() => Task.FromResult(folder.Names.Any(name => name.EndsWith(".json", StringComparison.Ordinal))));
        Assert.Equal(Ball, File.ReadAllText(folder[folder.Names.Single()]));
        Assert.Empty(web.Complaints);
    }

    /// <summary>The name of a model that looks like markup is text, like all the rest.</summary>
    [BrowserFact]
    public async Task ALinkHoldsTheSceneAndShowsItElsewhereAsText()
    {
        string link;
        await using (var web = await FolderPage.OpenAsync(chromium, site))
        {
            await web.Page.ClickOnAsync("#share-scene");
            await web.Page.WaitForFunctionAsync("() => /#scene=./.test(document.getElementById('share-link').value ?? '')");
            link = await web.Page.EvaluateExpressionAsync<string>("document.getElementById('share-link').value");
            Assert.StartsWith(web.Server.Address + "#scene=", link);
        }

        await using var other = await FolderPage.OpenAsync(chromium, site, fragment: link[link.IndexOf('#')..]);
        await other.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal(Ball, await other.SceneTextAsync());
        await other.Page.SaysAsync("<img src=x onerror=alert(1)>");
        Assert.Null(await other.Page.QuerySelectorAsync("img"));
        Assert.Empty(other.Complaints);
    }

    [BrowserFact]
    public async Task TheTextIsThereAgainAfterThePageWasLoadedAgain()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        await web.Page.ReloadAsync();
        await web.Page.ShowsPictureOfAsync(Ball);
        Assert.Equal(Ball, await web.SceneTextAsync());
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public async Task AModelsRaysAreShownAlsoIfTheyAreCountedBeforeTheModelsAreTold()
    {
        const string Rays = "() => document.getElementById('model-0-rays')?.textContent.includes('%')";
        await using var host = await FolderPage.OpenAsync(chromium, site, script: """
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
        await host.WriteSceneAsync(Ball.Replace("<img src=x onerror=alert(1)>", "other"));
        await host.Page.SaysAsync("other sphere");
        await host.Page.WaitForFunctionAsync(Rays);
    }
}
