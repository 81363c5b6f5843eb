namespace RayCaster.Page;

/// <summary>Draws for all pages, one picture after another: each takes every core.</summary>
internal class RenderQueue
{
    private readonly SemaphoreSlim turn = new(1, 1);

    /// <summary>How much processor time a diagnosis may take at most, if it has not done its usual work by then.</summary>
    public virtual TimeSpan SearchTime => SearchBudget.LastResort;

    public virtual Task<CanvasImage> DrawAsync(Scene scene, View view, CancellationToken cancellation) =>
        DoAsync(() => Draw(view.Of(scene), cancellation), cancellation);

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

    private static CanvasImage Draw(Scene scene, CancellationToken cancellation)
    {
        var picture = new Picture(scene.Camera.Width, scene.Camera.Height);
        new Renderer(scene) { ManyFrames = true }.DrawInto(picture, cancellation);
        return CanvasImage.Of(picture);
    }
}
