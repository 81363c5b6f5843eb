using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>A page whose program ends, starts again, or is suspended for a while.</summary>
[Collection("server")]
public class RestartTests(Chromium chromium)
{
    [BrowserFact]
    public async Task CtrlCEndsTheProgramWithAPageOpenAndThePageSaysSo()
    {
        using var folder = new TemporaryFolder();
        using var live = LiveProcess.Start(folder.Write("scene.json", Ball));
        await using var tab = await chromium.OpenAsync();
        await tab.ShowAsync(live.Address);
        var page = tab.Page;
        live.Send("INT");
        Assert.Equal(130, await live.ExitCodeAsync());
        await page.SaysAsync("The program has ended");
    }

    /// <summary>As "dotnet watch" does after a change of the code.</summary>
    [BrowserFact]
    public async Task APageContinuesWithItsCameraAndPixelWhenTheProgramIsStartedAgain()
    {
        using var folder = new TemporaryFolder();
        var scene = folder.Write("scene.json", Ball);
        var first = LiveProcess.Start(scene, 1, folder.Path);
        await using var tab = await chromium.OpenAsync();
        await tab.ShowAsync(first.Address);
        var page = tab.Page;
        await page.FocusAsync("#stage");
        await page.PressAsync("ArrowLeft");
        await page.ShowsAsync("#camera-reset:not([disabled])");
        var camera = await page.TextOfAsync("#camera-json");
        await page.PressAsync("Enter");
        await page.ShowsAsync("#pixel-head");
        first.Dispose();
        await page.ShowsAsync("body.apart");

        folder.Write("scene.json", Ball.Replace("\"models\"", "\"background\": [0, 0, 1], \"models\"").Replace("1, 0.5, 0.1", "0, 0, 0"));
        using var second = LiveProcess.Start(scene, 2, folder.Path);
        Assert.Equal(first.Address, second.Address);
        await page.ShowsAsync("body:not(.apart)");
        await page.WaitForFunctionAsync("() => /bytes 0 0 (0|255)\\n/.test(document.getElementById('pixel-head').textContent)");
        Assert.Equal(camera, await page.TextOfAsync("#camera-json"));
    }

    /// <summary>A program that is suspended for longer than the server waits for a browser's answer, as while a laptop sleeps.</summary>
    [BrowserFact]
    public async Task APageContinuesAfterASleep()
    {
        using var folder = new TemporaryFolder();
        using var live = LiveProcess.Start(folder.Write("scene.json", Ball), options: "--silence=1");
        await using var tab = await chromium.OpenAsync();
        await tab.ShowAsync(live.Address);
        var page = tab.Page;
        live.Send("STOP");
        folder.Write("scene.json", Ball.Replace("\"width\": 40", "\"width\": 44"));
        await Task.Delay(TimeSpan.FromSeconds(3));
        live.Send("CONT");
        await page.SaysAsync("Up to date: 44 × 30 pixels");
    }
}
