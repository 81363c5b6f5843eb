using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>What the page does whichever host it comes from.</summary>
public abstract class PageTests : HostTests
{
    [BrowserFact]
    public async Task EachByteOfThePictureIsTheDefinitionsAndThePageComplainsOfNothing()
    {
        await Page.ShowsPictureOfAsync(Ball);
        await Page.SaysAsync("Up to date: 40 × 30 pixels, 1 model.");
    }

    [BrowserFact]
    public async Task AChangedSceneIsShownAndABrokenOneTold()
    {
        await Host.WriteSceneAsync(Ball.Replace("\"radius\": 1", "\"radius\": 0"));
        await Page.ShowsAsync("aria/The scene file has 1 error[role=\"heading\"]");
        Assert.Contains("models[0].radius must be greater than 0", await Page.TextOfAsync("#problem-list"));
        Assert.Contains("1 error in", await Page.TextOfAsync("#status"));
        var changed = Ball.Replace("1, 0.5, 0.1", "0.1, 0.5, 1");
        await Host.WriteSceneAsync(changed);
        await Page.HidesAsync("#problems");
        await Page.ShowsPictureOfAsync(changed);
    }

    [BrowserFact]
    public async Task AClickExplainsThePixelInTheProgramsWordsAndArrowKeysStepOn()
    {
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        var sections = ExplanationText.Sections(new PixelExplanation(PageExtensions.Read(Ball), 20, 14), null);
        Assert.Contains("Column 20, line 14", await Page.TextOfAsync("#pixel-head"));
        Assert.Equal(
            sections.Skip(1).Select(section => section.Text),
            await Page.EvaluateExpressionAsync<string[]>("""
                [...document.querySelectorAll('#pixel-parts pre')].map(pre => [...pre.children].map(line => line.textContent + '\n').join(''))
                """));
        Assert.EndsWith("#pixel=20,14", Page.Url);
        Assert.NotNull(await Page.QuerySelectorAsync(".section path.shape"));

        await Page.PressAsync("ArrowRight");
        await Page.SaysAsync("Column 21, line 14");
        await Page.PressAsync("Escape");
        await Page.HidesAsync("#pixel-explained");
    }

    [BrowserFact]
    public async Task ADragTurnsTheCameraAndTheSceneTakesItOnlyWhenAsked()
    {
        await Page.ShowsAsync("#camera-json:not(:empty)");
        var before = await Page.TextOfAsync("#camera-json");
        var box = await Page.BoxOfAsync("#picture");
        await Page.Mouse.MoveAsync(box.X + 100, box.Y + 100);
        await Page.Mouse.DownAsync();
        await Page.Mouse.MoveAsync(box.X + 200, box.Y + 130, new() { Steps = 10 });
        await Page.Mouse.UpAsync();
        await Page.ShowsAsync("#camera-write:not([disabled])");
        Assert.NotEqual(before, await Page.TextOfAsync("#camera-json"));
        Assert.Equal(Ball, await Host.SceneTextAsync());

        await Page.ClickOnAsync("#camera-write");
        await Page.SaysAsync("Written into the scene file.");
        await PageExtensions.UntilAsync(async () => await Host.SceneTextAsync() != Ball);
        Assert.Contains("// a ball", await Host.SceneTextAsync());
        await Page.ShowsPictureOfAsync(await Host.SceneTextAsync());
    }

    [BrowserFact]
    public async Task APictureThatIsChosenIsComparedAndItsWorstPlaceExplained()
    {
        using var folder = new TemporaryFolder();
        await (await Page.QuerySelectorAsync("#mine-file")).UploadFileAsync(folder.Write("mine.png", PageExtensions.Png(new(40, 30))));
        await Page.ShowsAsync("#mine-worst:not([hidden])");
        await Page.SaysAsync("mine.png is wrong");
        await Page.SelectAsync("#mine-show", "difference");
        await Page.ShowsAsync("#mine:not([hidden])");
        await Page.ClickOnAsync("#mine-worst");
        await Page.WaitForFunctionAsync("() => document.getElementById('pixel-explained').textContent.includes('It has 0 0 0 here: different')");
    }

    [BrowserFact]
    public async Task AWrongPictureIsDiagnosed()
    {
        var room = File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Replace(": 500", ": 125");
        await Host.WriteSceneAsync(room);
        await Page.ShowsPictureOfAsync(room);
        await Page.DropAsync(MistakeCatalog.Draw(PageExtensions.Read(room), [MistakeCatalog.Named("nohalf")!.Usual]));
        await Page.SaysAsync("mine.png is wrong");
        await Page.SelectAsync("#hint", "answer");
        await Page.ClickOnAsync("#diagnose");
        await Page.HidesAsync("#diagnosing");
        Assert.Contains("nohalf", await Page.TextOfAsync("#diagnosis-text"));
    }

    [BrowserFact]
    public async Task ThePartsStandInTheSameOrderOnEachHost()
    {
        await Page.ClickOnPixelAsync(20, 14, 40, 30);
        await Host.WriteSceneAsync("{");
        await Page.ShowsAsync("#problems");
        string[] both = ["picture", "tools", "problems", "camera", "pixel", "models", "comparison"];
        var shown = await Page.EvaluateExpressionAsync<string[]>("""
            [...document.querySelectorAll('#picture, main section')].filter(part => part.checkVisibility()).map(part => part.id)
            """);
        Assert.Equal(both, shown.Where(part => part != "scene"));
    }
}
