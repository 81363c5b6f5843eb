namespace RayCaster.Live.Tests;

/// <summary>Fingers on a touch screen, a file that is dropped, and what the page does for people who set their system up.</summary>
[Collection("browser")]
public class HandTests(Chromium chromium)
{
    private const string Distance = """
        () => {
            const { position, target } = JSON.parse(`{${document.getElementById('camera-json').textContent}}`);
            return Math.hypot(...position.map((value, i) => value - target[i]));
        }
        """;

    [BrowserFact]
    public async Task OneFingerTurnsTwoFingersMoveAndATapExplains()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(
            live, new() { Width = 360, Height = 740, HasTouch = true });
        var touch = await page.CreateCDPSessionAsync();
        var box = await page.BoxOfAsync("#picture");
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        var before = await page.EvaluateFunctionAsync<double>(Distance);

        await DragAsync([(x, y)], [(x + 60, y)]);
        await page.ShowsAsync("#camera-reset:not([disabled])");
        Assert.Equal(before, await page.EvaluateFunctionAsync<double>(Distance), tolerance: 1e-3);

        await DragAsync([(x - 20, y), (x + 20, y)], [(x - 80, y), (x + 80, y)]);
        await page.WaitForFunctionAsync($"before => ({Distance})() < 0.5 * before", before);

        await page.Touchscreen.TapAsync(x, y);
        await page.ShowsAsync("#pixel-head");
        Assert.Empty(complaints);

        async Task DragAsync((decimal X, decimal Y)[] from, (decimal X, decimal Y)[] to)
        {
            await SendAsync("touchStart", from);
            for (var i = 1; i <= 10; i++)
                await SendAsync("touchMove", [.. from.Zip(to, (a, b) => (a.X + (b.X - a.X) * i / 10, a.Y + (b.Y - a.Y) * i / 10))]);
            await SendAsync("touchEnd", []);
        }

        Task SendAsync(string type, (decimal X, decimal Y)[] fingers) => touch.SendAsync("Input.dispatchTouchEvent", new
        {
            type,
            touchPoints = fingers.Select((finger, id) => new { x = finger.X, y = finger.Y, id }).ToArray(),
        });
    }

    [BrowserFact]
    public async Task AFileThatIsDroppedOnThePageIsCompared()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        PictureFile.Write(live.Folder["mine.png"], ScalarRenderer.Render(SceneReader.Read(live.Scene).Scene!));
        await page.DropAsync("mine.png", File.ReadAllBytes(live.Folder["mine.png"]), () => page.ShowsAsync("body.dropping"));
        await page.SaysAsync("mine.png is compared: identical.");
        Assert.Null(await page.QuerySelectorAsync("body.dropping"));
        Assert.Empty(complaints);
    }

    /// <summary>WCAG 2.2: 4.5 for text, on every background that is behind it.</summary>
    [BrowserFact]
    public async Task TextHasEnoughContrastInLightAndDark()
    {
        await using var live = await LivePage.OpenAsync();
        foreach (var isDark in new[] { false, true })
        {
            var (page, _) = await chromium.OpenAsync(live, isDark: isDark);
            await page.FocusAsync("#stage");
            await page.PressAsync("Enter");
            await page.ShowsAsync("#pixel-head");
            Assert.Equal("", await page.FaintTextsAsync());
        }
    }
}
