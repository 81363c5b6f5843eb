namespace RayCaster.Web;

/// <summary>Draws some lines at a time, and listens to the page between them: a worker has one thread.</summary>
internal sealed class ChunkedRenderQueue : RenderQueue
{
    /// <summary>So many pixels take less than a tenth of a second. A tile of the engine has so many lines.</summary>
    private const int PixelsAtOnce = 1 << 15, Step = 64;

    /// <summary>The browser interprets the program, and a search then takes some ten times as long.</summary>
    public override TimeSpan SearchTime => TimeSpan.FromMinutes(5);

    public override async Task<CanvasImage> DrawAsync(Scene scene, View view, CancellationToken cancellation)
    {
        var seen = view.Of(scene);
        var (width, height) = (seen.Camera.Width, seen.Camera.Height);
        var picture = new Picture(width, height);
        var renderer = new Renderer(seen) { ManyFrames = true };
        var lines = Math.Max(1, PixelsAtOnce / width / Step) * Step;
        var done = 0; // bytes
        for (var line = 0; line < height; line += lines)
        {
            var difference = renderer.Draw(line..Math.Min(height, line + lines), rgb =>
            {
                rgb.CopyTo(picture.Rgb.AsSpan(done));
                done += rgb.Length;
            }, cancellation: cancellation);
            EngineDisagreesException.ThrowIf(difference);
            await Task.Delay(1, cancellation);
        }
        return CanvasImage.Of(picture);
    }
}
