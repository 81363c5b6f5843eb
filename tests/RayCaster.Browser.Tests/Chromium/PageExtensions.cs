using System.Diagnostics;

namespace RayCaster.Browser.Tests;

/// <summary>What a user waits for, reads and does.</summary>
internal static class PageExtensions
{
    extension(IPage page)
    {
        /// <summary>Waits until an element is visible.</summary>
        public Task<IElementHandle> ShowsAsync(string selector) => page.WaitForSelectorAsync(selector, new() { Visible = true });

        /// <summary>Waits until an element is not visible.</summary>
        public Task HidesAsync(string selector) => page.WaitForSelectorAsync(selector, new() { Hidden = true });

        /// <summary>Waits until the page shows a text.</summary>
        public Task SaysAsync(string text) => page.WaitForFunctionAsync("text => document.body.innerText.includes(text)", text);

        /// <summary>The text that an element shows.</summary>
        public Task<string> TextOfAsync(string selector) =>
            page.EvaluateFunctionAsync<string>("selector => document.querySelector(selector).innerText", selector);

        public async Task<BoundingBox> BoxOfAsync(string selector) => await (await page.ShowsAsync(selector)).BoundingBoxAsync();

        public Task PressAsync(string key) => page.Keyboard.PressAsync(key);

        /// <summary>Clicks on an element once it is visible.</summary>
        public async Task ClickOnAsync(string selector) => await (await page.ShowsAsync(selector)).ClickAsync();

        /// <summary>Clicks on a pixel of the picture.</summary>
        public async Task ClickOnPixelAsync(double column, double line, double width, double height)
        {
            var box = await page.BoxOfAsync("#picture");
            await page.Mouse.ClickAsync(box.X + box.Width * (decimal)((column + 0.5) / width), box.Y + box.Height * (decimal)((line + 0.5) / height));
            await page.ShowsAsync("#pixel-head");
        }

        /// <summary>Explains the pixel in the middle, by the keyboard.</summary>
        public async Task ExplainAsync()
        {
            await page.FocusAsync("#stage");
            await page.PressAsync("Enter");
            await page.ShowsAsync("#pixel-head");
        }

        /// <summary>Waits until the page shows exactly the picture that the program draws of a scene.</summary>
        public async Task ShowsPictureOfAsync(Scene scene) => await page.WaitForFunctionAsync("""
            (width, height, base64) => {
                const picture = document.getElementById('picture');
                if (picture.dataset.final !== 'true' || picture.width !== width || picture.height !== height) return false;
                const bytes = picture.getContext('2d').getImageData(0, 0, width, height).data, right = atob(base64);
                for (let i = 0; i < width * height; i++)
                    for (let c = 0; c < 3; c++) if (bytes[4 * i + c] !== right.charCodeAt(3 * i + c)) return false;
                return true;
            }
            """, new WaitForFunctionOptions { PollingInterval = 100 },
            scene.Camera.Width, scene.Camera.Height, Convert.ToBase64String(ScalarRenderer.Render(scene).Rgb));

        public Task ShowsPictureOfAsync(string scene) => page.ShowsPictureOfAsync(Read(scene));

        /// <summary>Drops a picture on the page.</summary>
        public Task DropAsync(Picture picture, Func<Task>? dragged = null) => page.DropAsync("mine.png", Png(picture), dragged);

        /// <summary>Drags a file over the page and drops it there.</summary>
        /// <param name="dragged">What to do while it is over the page.</param>
        public async Task DropAsync(string name, byte[] bytes, Func<Task>? dragged = null)
        {
            var transfer = await page.EvaluateFunctionHandleAsync("""
                (name, base64) => {
                    const transfer = new DataTransfer();
                    transfer.items.add(new File([Uint8Array.from(atob(base64), c => c.charCodeAt(0))], name));
                    return transfer;
                }
                """, name, Convert.ToBase64String(bytes));
            await DispatchAsync("dragover");
            if (dragged is not null) await dragged();
            await DispatchAsync("drop");

            Task DispatchAsync(string type) => page.EvaluateFunctionAsync("""
                (type, dataTransfer) => document.getElementById('camera').dispatchEvent(
                    new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }))
                """, type, transfer);
        }

        /// <summary>The texts with too little contrast. WCAG 2.2: 4.5, on every background that is behind a text.</summary>
        public Task<string> FaintTextsAsync() => page.EvaluateFunctionAsync<string>("""
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
            """);
    }

    public static Scene Read(string scene) => SceneReader.Parse(System.Text.Encoding.UTF8.GetBytes(scene), "scene.json", "").Scene!;

    public static byte[] Png(Picture picture)
    {
        using var stream = new MemoryStream();
        PictureFile.Write(stream, picture, PictureFormat.Png);
        return stream.ToArray();
    }

    /// <summary>Waits for what the browser's own waiting cannot see.</summary>
    public static async Task UntilAsync(Func<Task<bool>> holds)
    {
        var start = Stopwatch.GetTimestamp();
        while (!await holds())
        {
            if (Stopwatch.GetElapsedTime(start) > TimeSpan.FromMinutes(2)) throw new TimeoutException("It does not hold after two minutes.");
            await Task.Delay(20);
        }
    }
}
