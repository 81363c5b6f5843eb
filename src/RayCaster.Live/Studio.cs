namespace RayCaster.Live;

/// <summary>Draws for all pages, one picture after another: each takes every core.</summary>
internal sealed class Studio
{
    private readonly SemaphoreSlim turn = new(1, 1);

    public Task<Frame> DrawAsync(Scene scene, View view, CancellationToken cancellation) =>
        DoAsync(() => Draw(view.Of(scene), view, cancellation), cancellation);

    /// <summary>Does work that takes all cores, after the work before it.</summary>
    public async Task<T> DoAsync<T>(Func<T> work, CancellationToken cancellation)
    {
        await turn.WaitAsync(cancellation);
        try
        {
            return work();
        }
        finally
        {
            turn.Release();
        }
    }

    private static Frame Draw(Scene scene, View view, CancellationToken cancellation)
    {
        var model = view.Model < scene.Models.Count ? view.Model : -1; // it may have been deleted in the file
        if (view.Look != Look.Plain) return Frame.Of(ModelPicture.Draw(scene, view.Look, model, cancellation));
        var frame = new Frame(scene.Camera.Width, scene.Camera.Height);
        var pixel = 0;
        try
        {
            new Renderer(scene) { ManyFrames = true }.Draw(.., lines =>
            {
                frame.Fill(lines, pixel);
                pixel += lines.Length / 3;
            }, cancellation: cancellation);
            return frame;
        }
        catch (EngineDisagreesException e)
        {
            Renderer.Disagreed?.Invoke(e.Message);
            return Frame.Of(ScalarRenderer.Render(scene));
        }
    }
}

/// <summary>The memory for one page's frames while its camera moves: new memory for each frame would take longer to clear than to fill.</summary>
internal sealed class MovingBuffer
{
    private Picture? picture;
    private Frame? shown, next; // one is sent while the next is drawn

    /// <summary>Draws a scene. The second call after this one overwrites the frame.</summary>
    public Frame Draw(Scene scene)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        if ((picture?.Width, picture?.Height) != (width, height))
            (picture, shown, next) = (new(width, height), new(width, height), new(width, height));
        new Renderer(scene) { ManyFrames = true }.DrawInto(picture!);
        (shown, next) = (next, shown);
        return shown!.Fill(picture!.Rgb);
    }
}
