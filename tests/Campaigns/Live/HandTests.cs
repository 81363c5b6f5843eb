using Microsoft.Playwright;

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
            live, new() { ViewportSize = new() { Width = 360, Height = 740 }, HasTouch = true });
        var touch = await page.Context.NewCDPSessionAsync(page);
        var box = (await page.Locator("#picture").BoundingBoxAsync())!;
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        var before = await page.EvaluateAsync<double>(Distance);

        await DragAsync([(x, y)], [(x + 60, y)]);
        await page.WaitForSelectorAsync("#camera-reset:not([disabled])");
        Assert.Equal(before, await page.EvaluateAsync<double>(Distance), tolerance: 1e-3);

        await DragAsync([(x - 20, y), (x + 20, y)], [(x - 80, y), (x + 80, y)]);
        await page.WaitForFunctionAsync($"before => ({Distance})() < 0.5 * before", before);

        await page.Touchscreen.TapAsync(x, y);
        await page.WaitForSelectorAsync("#pixel-bytes");
        Assert.Empty(complaints);

        async Task DragAsync((float X, float Y)[] from, (float X, float Y)[] to)
        {
            await SendAsync("touchStart", from);
            for (var i = 1; i <= 10; i++)
                await SendAsync("touchMove", [.. from.Zip(to, (a, b) => (a.X + (b.X - a.X) * i / 10, a.Y + (b.Y - a.Y) * i / 10))]);
            await SendAsync("touchEnd", []);
        }

        Task SendAsync(string type, (float X, float Y)[] fingers) => touch.SendAsync("Input.dispatchTouchEvent", new()
        {
            ["type"] = type,
            ["touchPoints"] = fingers.Select((finger, id) => new { x = finger.X, y = finger.Y, id }).ToArray(),
        });
    }

    [BrowserFact]
    public async Task AFileThatIsDroppedOnThePageIsCompared()
    {
        await using var live = await LivePage.OpenAsync();
        var (page, complaints) = await chromium.OpenAsync(live);
        PictureFile.Write(live.Folder["mine.png"], ScalarRenderer.Render(SceneReader.Read(live.Scene).Scene!));
        var transfer = await page.EvaluateHandleAsync("""
            base64 => {
                const transfer = new DataTransfer();
                transfer.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], 'mine.png', { type: 'image/png' }));
                return transfer;
            }
            """, Convert.ToBase64String(File.ReadAllBytes(live.Folder["mine.png"])));
        await page.DispatchEventAsync("#camera", "dragover", new { dataTransfer = transfer });
        await page.WaitForSelectorAsync("body.dropping");
        await page.DispatchEventAsync("#camera", "drop", new { dataTransfer = transfer });
        await page.GetByText("mine.png is compared: identical.").WaitForAsync();
        Assert.Equal(0, await page.Locator("body.dropping").CountAsync());
        Assert.Empty(complaints);
    }

    /// <summary>WCAG 2.2: 4.5 for text, on every background that is behind it.</summary>
    [BrowserFact]
    public async Task TextHasEnoughContrastInLightAndDark()
    {
        await using var live = await LivePage.OpenAsync();
        foreach (var scheme in new[] { ColorScheme.Light, ColorScheme.Dark })
        {
            var (page, _) = await chromium.OpenAsync(
                live, new() { ViewportSize = new() { Width = 1300, Height = 900 }, ColorScheme = scheme });
            await page.FocusAsync("#stage");
            await page.Keyboard.PressAsync("Enter");
            await page.WaitForSelectorAsync("#pixel-bytes");
            await page.ClickAsync("#model-0-behind");
            Assert.Equal("", await page.EvaluateAsync<string>("""
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
