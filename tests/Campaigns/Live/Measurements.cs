using System.Diagnostics;
using Xunit.Abstractions;

namespace RayCaster.Live.Tests;

/// <summary>
/// What a user waits for on the live page. These are no tests: on a busy machine the figures are worse. docs/live.md has the command.
/// </summary>
[Collection("alone")]
public class Measurements(Chromium chromium, ITestOutputHelper output) : IClassFixture<Chromium>
{
    private const int Saves = 30, Seconds = 5;

    /// <summary>The time from writing the file to the picture on the canvas.</summary>
    [BrowserFact(measures: true)]
    public async Task FromSaveToPicture()
    {
        var scene = File.ReadAllText(ProjectFolder.PathOf("scenes/room.json"));
        await using var live = await LivePage.OpenAsync(scene);
        var (page, _) = await chromium.OpenAsync(live);
        var times = new List<double>();
        for (var i = 1; i <= Saves; i++)
        {
            var version = int.Parse((await page.GetAttributeAsync("#picture", "data-version"))!);
            var shown = page.WaitForFunctionAsync(
                "v => +document.getElementById('picture').dataset.version > v", version, new() { PollingInterval = 1 });
            await Task.Delay(300);
            var start = Stopwatch.GetTimestamp();
            File.WriteAllText(live.Scene, scene.Replace("\"fovY\": 45", FormattableString.Invariant($"\"fovY\": {45 + 0.1 * i}")));
            await shown;
            times.Add(Stopwatch.GetElapsedTime(start).TotalMilliseconds);
        }
        times.Sort();
        output.WriteLine(
            $"room.json, save to picture: median {times[Saves / 2]:f0} ms, least {times[0]:f0}, greatest {times[^1]:f0}, of {Saves} saves");
    }

    /// <summary>From the moment at which the browser asks for the page to its first paint.</summary>
    [BrowserFact(measures: true)]
    public async Task FirstPaint()
    {
        var times = new List<double>();
        for (var i = 0; i < 9; i++)
        {
            await using var live = await LivePage.OpenAsync(File.ReadAllText(ProjectFolder.PathOf("scenes/room.json")));
            var (page, _) = await chromium.OpenAsync(live);
            times.Add(await page.EvaluateAsync<double>("() => performance.getEntriesByName('first-contentful-paint')[0].startTime"));
            await page.CloseAsync();
        }
        times.Sort();
        output.WriteLine($"first paint: median {times[times.Count / 2]:f0} ms, greatest {times[^1]:f0}, of {times.Count}");
    }

    /// <summary>How many frames the browser shows while the mouse drags for some seconds, and their size.</summary>
    [BrowserFact(measures: true)]
    public async Task FramesWhileDragging()
    {
        await FramesAsync("room.json", File.ReadAllText(ProjectFolder.PathOf("scenes/room.json"))
            .Replace("\"width\": 500", "\"width\": 1280").Replace("\"height\": 500", "\"height\": 720"), _ => { });
        foreach (var (name, depth) in new[] { ("82,000 triangles", 6), ("1.3 million triangles", 8) })
            await FramesAsync(name, Scene("""{ "type": "mesh", "file": "ball.ply", "color": [1, 0.8, 0.2] }"""),
                folder => File.WriteAllBytes(folder["ball.ply"], MeshWriter.PlyFloat(MeshGenerator.Icosphere(depth))));
        var random = new Random(1);
        double Next() => Math.Round(2 * random.NextDouble() - 1, 4);
        var spheres = from i in Enumerable.Range(0, 100_000)
                      select FormattableString.Invariant(
                          $$"""{ "type": "sphere", "center": [{{Next()}}, {{Next()}}, {{Next()}}], "radius": 0.01 }""");
        await FramesAsync("100,000 spheres", Scene(string.Join(",\n", spheres)), _ => { });
    }

    private static string Scene(string models) =>
        $$"""{ "camera": { "position": [4, 0, 1], "target": [0, 0, 0], "fovY": 35, "width": 1280, "height": 720 }, "models": [ {{models}} ] }""";

    private async Task FramesAsync(string name, string scene, Action<TemporaryFolder> prepare)
    {
        await using var live = await LivePage.OpenAsync(scene, prepare: prepare);
        var (page, _) = await chromium.OpenAsync(live, new() { ViewportSize = new() { Width = 1280, Height = 1000 } });
        await Task.Delay(3000);
        var box = (await page.Locator("#picture").BoundingBoxAsync())!;
        var (x, y) = (box.X + box.Width / 2, box.Y + box.Height / 2);
        await page.Mouse.MoveAsync(x, y);
        await page.Mouse.DownAsync();
        var sizes = page.EvaluateAsync<double[]>($$"""
            () => new Promise(done => {
                const canvas = document.getElementById('picture'), from = +canvas.dataset.frames, start = performance.now();
                let sum = 0, count = 0;
                document.getElementById('stage').addEventListener('frame', event => { sum += event.detail.width; count++; });
                setTimeout(() => done([(+canvas.dataset.frames - from) / (performance.now() - start) * 1000, sum / count]), {{Seconds}}000);
            })
            """);
        for (var start = Stopwatch.GetTimestamp(); Stopwatch.GetElapsedTime(start).TotalSeconds < Seconds;)
        {
            var angle = Stopwatch.GetElapsedTime(start).TotalSeconds;
            await page.Mouse.MoveAsync(x + 150 * (float)Math.Sin(angle), y + 100 * (float)Math.Sin(0.7 * angle));
            await Task.Delay(8);
        }
        await page.Mouse.UpAsync();
        var last = Stopwatch.GetTimestamp();
        await page.WaitForSelectorAsync("#picture[data-final=true]");
        var sharp = Stopwatch.GetElapsedTime(last).TotalMilliseconds;
        var figures = await sizes;
        output.WriteLine($"{name}: {figures[0]:f0} frames a second, {figures[1]:f0} pixels wide while moving, sharp after {sharp:f0} ms");
    }
}
