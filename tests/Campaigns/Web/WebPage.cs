using PuppeteerSharp;

namespace RayCaster.Web.Tests;

/// <summary>The page of the folder, in a browser that has never seen it.</summary>
internal sealed class WebPage : IAsyncDisposable
{
    private WebPage(FileServer server, IBrowserContext alone, IPage page, List<string> complaints) =>
        (Server, Alone, Page, Complaints) = (server, alone, page, complaints);

    public FileServer Server { get; }

    public IBrowserContext Alone { get; }

    public IPage Page { get; }

    /// <summary>What the page has written to the console, and its errors.</summary>
    public List<string> Complaints { get; }

    /// <param name="below">The folder of the host that the site is in.</param>
    /// <param name="fragment">What follows the address, beginning with #.</param>
    /// <param name="isProxied">Whether requests for other hosts reach the file server, too.</param>
    public static async Task<WebPage> OpenAsync(
        Chromium chromium, Site site, string below = "", string fragment = "", bool isProxied = false, ViewPortOptions? size = null)
    {
        var server = await site.ServeAsync(below);
        var alone = await chromium.AloneAsync(isProxied ? server.Root : null);
        var (page, complaints) = await chromium.OpenAsync(server.Address + fragment, size, alone: alone);
        page.DefaultTimeout = 120_000; // beside other work
        return new(server, alone, page, complaints);
    }

    public async ValueTask DisposeAsync()
    {
        await Alone.CloseAsync();
        await Server.DisposeAsync();
    }
}

/// <summary>What these tests do with the page more than once.</summary>
internal static class WebPageExtensions
{
    extension(IPage page)
    {
        /// <summary>Puts a text into the editor, as if it were pasted.</summary>
        public Task WriteSceneAsync(string text) => page.EvaluateFunctionAsync("""
            text => {
                const editor = document.getElementById('scene-text');
                editor.value = text;
                editor.dispatchEvent(new Event('input', { bubbles: true }));
            }
            """, text);

        public Task<string> SceneTextAsync() => page.EvaluateExpressionAsync<string>("document.getElementById('scene-text').value");

        /// <summary>Waits until the page shows a scene's picture at rest, of this size.</summary>
        public Task ShowsSizeAsync(int width, int height) => page.WaitForFunctionAsync("""
            (width, height) => {
                const { width: w, height: h, dataset } = document.getElementById('picture');
                return dataset.final === 'true' && w === width && h === height;
            }
            """, width, height);

        /// <summary>Waits until the page shows exactly the picture that the program draws of a scene.</summary>
        public async Task ShowsPictureOfAsync(Scene scene)
        {
            await page.ShowsSizeAsync(scene.Camera.Width, scene.Camera.Height);
            var right = ScalarRenderer.Render(scene).Rgb;
            await page.WaitForFunctionAsync("""
                base64 => {
                    const { width, height } = document.getElementById('picture');
                    const bytes = document.getElementById('picture').getContext('2d').getImageData(0, 0, width, height).data;
                    const right = atob(base64);
                    for (let i = 0; i < width * height; i++)
                        for (let c = 0; c < 3; c++) if (bytes[4 * i + c] !== right.charCodeAt(3 * i + c)) return false;
                    return true;
                }
                """, new WaitForFunctionOptions { PollingInterval = 500 }, Convert.ToBase64String(right));
        }

        public Task ShowsPictureOfAsync(string scene) =>
            page.ShowsPictureOfAsync(SceneReader.Parse(System.Text.Encoding.UTF8.GetBytes(scene), "scene.json", "").Scene!);

        /// <summary>Explains the pixel in the middle, by the keyboard.</summary>
        public async Task ExplainAsync()
        {
            await page.FocusAsync("#stage");
            await page.PressAsync("Enter");
            await page.ShowsAsync("#pixel-head");
        }

        /// <summary>Drops a wrong picture of the room, and waits for its comparison.</summary>
        public async Task DropWrongAsync()
        {
            using var folder = new TemporaryFolder();
            PictureFile.Write(folder["mine.png"], new Picture(500, 500));
            await page.DropAsync("mine.png", File.ReadAllBytes(folder["mine.png"]));
            await page.SaysAsync("mine.png is wrong");
        }

        /// <summary>The bytes of the picture that the page shows, three for each pixel.</summary>
        public async Task<byte[]> BytesAsync() => Convert.FromBase64String(await page.EvaluateFunctionAsync<string>("""
            () => {
                const { width, height } = document.getElementById('picture');
                const bytes = document.getElementById('picture').getContext('2d').getImageData(0, 0, width, height).data;
                let text = '';
                for (let i = 0; i < bytes.length; i += 4) text += String.fromCharCode(bytes[i], bytes[i + 1], bytes[i + 2]);
                return btoa(text);
            }
            """));
    }
}
