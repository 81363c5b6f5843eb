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
        var transfer = await page.EvaluateFunctionHandleAsync("""
            base64 => {
                const transfer = new DataTransfer();
                transfer.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], 'mine.png', { type: 'image/png' }));
                return transfer;
            }
            """, Convert.ToBase64String(File.ReadAllBytes(live.Folder["mine.png"])));
        await DispatchAsync("dragover");
        await page.ShowsAsync("body.dropping");
        await DispatchAsync("drop");
        await page.SaysAsync("mine.png is compared: identical.");
        Assert.Null(await page.QuerySelectorAsync("body.dropping"));
        Assert.Empty(complaints);

        Task DispatchAsync(string type) => page.EvaluateFunctionAsync("""
            (type, dataTransfer) => document.getElementById('camera').dispatchEvent(
                new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }))
            """, type, transfer);
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
            Assert.Equal("", await page.EvaluateFunctionAsync<string>("""
                () => {
                    const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
                    const bytes = color => {
                        canvas.clearRect(0, 0, 1, 1);
                        canvas.fillStyle = color;
                        canvas.fillRect(0, 0, 1, 1);
                        return [...canvas.getImageData(0, 0, 1, 1).data];
                    };
                    const linear = level => level <= 0.04045 ? level / 12.92 : ((level + 0.055) / 1.055) ** 2.4;
                    const light = ([r, g, b]) => 0.2126 * linear(r / 255) + 0.7152 * linear(g / 255) + 0.0722 * linear(b / 255);
                    const behind = element => {
                        for (; element; element = element.parentElement) {
                            const color = bytes(getComputedStyle(element).backgroundColor);
                            if (color[3] === 255) return color;
                        }
                        return [255, 255, 255];
                    };
                    const faint = [];
                    for (const element of document.querySelectorAll('body *:not(script)')) {
                        if (element.disabled || element.closest('svg') || !element.checkVisibility()) continue;
                        if (![...element.childNodes].some(node => node.nodeType === Node.TEXT_NODE && node.data.trim())) continue;
                        const [text, back] = [light(bytes(getComputedStyle(element).color)), light(behind(element))];
                        const ratio = (Math.max(text, back) + 0.05) / (Math.min(text, back) + 0.05);
                        if (ratio < 4.5) faint.push(`${element.textContent.slice(0, 30)}: ${ratio.toFixed(2)}`);
                    }
                    return faint.join('\n');
                }
                """));
        }
    }
}
