using System.Diagnostics;

namespace RayCaster.Live;

/// <summary>Draws for all pages, one picture after another: each takes every core. What several pages look at is drawn once.</summary>
internal sealed class Studio
{
    private const int MostRehearsals = 60;

    private static readonly TimeSpan LongestWarmUp = TimeSpan.FromSeconds(2);

    private readonly SemaphoreSlim turn = new(1, 1);
    private (SceneState? State, View? View, Frame? Frame) last;

    /// <summary>The picture of a view at rest.</summary>
    /// <param name="state">Of which scene.</param>
    /// <param name="view">How it is looked at.</param>
    /// <param name="cancellation">Ends the work: the scene says something else by now.</param>
    public async Task<Frame> DrawAsync(SceneState state, View view, CancellationToken cancellation)
    {
        await turn.WaitAsync(cancellation);
        try
        {
            if (ReferenceEquals(last.State, state) && last.View == view && last.Frame is { } known) return known;
            var frame = Draw(view.Of(state.Scene!), view, cancellation);
            last = (state, view, frame);
            return frame;
        }
        finally
        {
            turn.Release();
        }
    }

    /// <summary>The picture of a view that moves: into memory that is there already, and small, so that it need not be cut short.</summary>
    /// <param name="scene">The scene as it is looked at.</param>
    /// <param name="buffer">Memory of the frames before.</param>
    /// <param name="cancellation">Ends the wait for the others.</param>
    public async Task<Frame> DrawAsync(Scene scene, MovingBuffer buffer, CancellationToken cancellation)
    {
        await turn.WaitAsync(cancellation);
        try
        {
            return buffer.Draw(scene);
        }
        finally
        {
            turn.Release();
        }
    }

    /// <summary>Draws what nobody sees, so that the runtime has optimised what draws before somebody turns the camera. Others go first.</summary>
    public void WarmUp(Scene scene)
    {
        new Thread(() =>
        {
            var buffer = new MovingBuffer();
            var view = new View(Divisor: 4).Of(scene);
            for (var (i, start) = (0, Stopwatch.GetTimestamp()); i < MostRehearsals && Stopwatch.GetElapsedTime(start) < LongestWarmUp; i++)
            {
                Thread.Sleep(2);
                turn.Wait();
                buffer.Draw(view);
                turn.Release();
            }
        })
        { IsBackground = true, Priority = ThreadPriority.Lowest, Name = "warm-up" }.Start();
    }

    /// <summary>Does other work that takes all cores.</summary>
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
        if (view.Look != Look.Plain) return Frame.Of(ModelPicture.Draw(scene, view.Look, view.Model, cancellation));
        var frame = new Frame(scene.Camera.Width, scene.Camera.Height);
        var check = ScalarRenderer.IsChanged ? new DefinitionCheck(scene, 0..scene.Camera.Height) : null;
        var pixel = 0;
        new Renderer(scene) { ManyFrames = true }.Draw(lines =>
        {
            check?.Take(lines);
            frame.Fill(lines, pixel);
            pixel += lines.Length / 3;
        }, cancellation: cancellation);
        // What is read is what draws: where the fast way no longer agrees with a change, the definition draws.
        return check?.FirstDifference() is null ? frame : Frame.Of(ScalarRenderer.Render(scene));
    }
}

/// <summary>What one page's frames are drawn into while its camera moves: thirty times a second new memory would be too much to clear.</summary>
internal sealed class MovingBuffer
{
    private Picture? picture;
    private Frame? shown, next; // one is sent while the next is drawn

    /// <summary>Draws a scene. The frame is overwritten by the one after the next.</summary>
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
