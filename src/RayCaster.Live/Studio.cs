using System.Diagnostics;

namespace RayCaster.Live;

/// <summary>Draws for all pages, one picture after another: each takes every core.</summary>
internal sealed class Studio
{
    private const int MostWarmUpFrames = 60, LongestWarmUpMilliseconds = 2000;

    private readonly SemaphoreSlim turn = new(1, 1);
    private int isWarm;

    /// <summary>The picture of a view at rest.</summary>
    /// <param name="cancellation">Abandons the picture, as when the scene changes.</param>
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

    /// <summary>
    /// Draws small frames that no page shows, so that the runtime has optimised the code before a camera moves. Only the first call has an effect.
    /// </summary>
    public void WarmUp(Scene scene)
    {
        if (Interlocked.Exchange(ref isWarm, 1) != 0) return;
        new Thread(() =>
        {
            var buffer = new MovingBuffer();
            var view = new View(Divisor: 4).Of(scene);
            var watch = Stopwatch.StartNew();
            for (var i = 0; i < MostWarmUpFrames && watch.ElapsedMilliseconds < LongestWarmUpMilliseconds; i++)
            {
                Thread.Sleep(2); // pages that wait draw first
                turn.Wait();
                try
                {
                    buffer.Draw(view);
                }
                catch (Exception) when (ScalarRenderer.IsChanged)
                {
                    return; // a page whose picture has the same fault shows it
                }
                finally
                {
                    turn.Release();
                }
            }
        })
        { IsBackground = true, Priority = ThreadPriority.Lowest, Name = "warm-up" }.Start();
    }

    private static Frame Draw(Scene scene, View view, CancellationToken cancellation)
    {
        if (view.Look != Look.Plain) return Frame.Of(ModelPicture.Draw(scene, view.Look, view.Model, cancellation));
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
