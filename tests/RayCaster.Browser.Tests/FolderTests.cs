using System.IO.Compression;
using System.Text.RegularExpressions;
using static RayCaster.Browser.Tests.HostedPage;

namespace RayCaster.Browser.Tests;

/// <summary>The page without a server: as any other, and what follows from its being a folder of files.</summary>
[Collection("folder")]
public partial class FolderTests(Chromium chromium, Site site) : PageTests
{
    private protected override async Task<HostedPage> OpenAsync(string scene = Ball) =>
        await FolderPage.OpenAsync(chromium, site, FolderPage.Link(scene));

    [BrowserFact]
    public async Task TheFirstSceneIsTheRoomAndAFolderOfAHostWillDo()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site, below: "/course/live");
        await web.Page.ShowsPictureOfAsync(SceneReader.Read(ProjectFolder.PathOf("scenes/room.json")).Scene!);
        Assert.Equal(File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")).Trim(), (await web.SceneTextAsync()).Trim());
        Assert.Empty(web.Complaints);
    }

    [BrowserFact]
    public void TheFirstVisitLoadsAsManyMegabytesAsTheDocsSay()
    {
        var files = site.Files().Select(File.ReadAllBytes).ToArray();
        var told = Visit().Match(File.ReadAllText(ProjectFolder.PathOf("docs/live.md")));
        Is("brotli", stream => new BrotliStream(stream, CompressionLevel.SmallestSize));
        Is("gzip", stream => new GZipStream(stream, CompressionLevel.Optimal));
        Is("plain", stream => stream);

        void Is(string host, Func<Stream, Stream> compress)
        {
            var sum = 0L;
            foreach (var file in files)
            {
                using var compressed = new MemoryStream();
                using (var stream = compress(compressed)) stream.Write(file);
                sum += compressed.ToArray().Length;
            }
            Assert.Equal((host, told.Groups[host].Value), (host, FormattableString.Invariant($"{sum / 1e6:0.0}")));
        }
    }

    [BrowserFact]
    public async Task FramesComeDuringADragAndTheCameraHasTurnedAfterIt()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        var page = web.Page;
        var before = await page.TextOfAsync("#camera-json");
        await DragAsync(page, frames: 3);
        await page.ShowsAsync("#picture[data-final=true]");
        await page.WaitForFunctionAsync("before => document.getElementById('camera-json').innerText !== before", before);
        Assert.Empty(web.Complaints);
    }

    /// <summary>The longest time in which the page draws nothing, while a picture is drawn after a drag. The worker needs more than a second for
    /// it; the page would stand still so long if it drew by itself.</summary>
    [BrowserFact]
    public async Task ThePageDoesNotStandStillWhileAPictureIsDrawn()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        var page = web.Page;
        await DragAsync(page, frames: 1);
        var times = await page.EvaluateFunctionAsync<double[]>("""
            () => new Promise(done => {
                const start = performance.now();
                let last = start, longest = 0;
                requestAnimationFrame(function tick() {
                    const now = performance.now();
                    longest = Math.max(longest, now - last);
                    last = now;
                    if (document.getElementById('picture').dataset.final === 'true') done([longest, now - start]);
                    else requestAnimationFrame(tick);
                });
            })
            """);
        Assert.True(times[0] < times[1] / 2, $"{times[0]:0} of {times[1]:0} ms without a frame");
    }

    [BrowserFact]
    public async Task ALongDiagnosisShowsThatItRunsAndCanBeCancelled()
    {
        await using var web = await FolderPage.OpenAsync(chromium, site);
        var page = web.Page;
        var noise = new Picture(500, 500);
        new Random(20261127).NextBytes(noise.Rgb);
        await page.DropAsync(noise);
        await page.SaysAsync("mine.png is wrong");
        var workers = page.Workers.Length;
        await page.ClickOnAsync("#diagnose");
        await page.ShowsAsync("#diagnosing");
        Assert.Equal("Cancel", await page.TextOfAsync("#diagnose"));
        await page.ClickOnAsync("#diagnose");
        await page.HidesAsync("#diagnosing");
        Assert.Equal("The diagnosis was cancelled.", await page.TextOfAsync("#diagnosis-text"));
        Assert.Equal("Diagnose", await page.TextOfAsync("#diagnose"));
        await PageExtensions.UntilAsync(() => Task.FromResult(page.Workers.Length <= workers)); // nothing goes on searching
        Assert.Empty(web.Complaints);
    }

    /// <summary>Drags until so many frames of a moving camera have come, and lets go.</summary>
    private static async Task DragAsync(IPage page, int frames)
    {
        await page.EvaluateExpressionAsync("""
            window.moving = 0;
            document.getElementById('stage').addEventListener('frame', event => { if (!event.detail.isFinal) moving++; });
            """);
        var box = await page.BoxOfAsync("#picture");
        var (x, y) = (box.X + 100, box.Y + 100);
        await page.Mouse.MoveAsync(x, y);
        await page.Mouse.DownAsync();
        var step = 0;
        await PageExtensions.UntilAsync(async () =>
        {
            await page.Mouse.MoveAsync(x + ++step % 100, y + 30);
            return await page.EvaluateExpressionAsync<int>("moving") >= frames;
        });
        await page.Mouse.UpAsync();
    }

    [GeneratedRegex(@"loads (?<brotli>[\d.]+) MB if the host compresses with Brotli, (?<gzip>[\d.]+) MB with gzip, (?<plain>[\d.]+) MB if")]
    private static partial Regex Visit();
}
