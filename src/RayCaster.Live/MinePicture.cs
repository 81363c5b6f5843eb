namespace RayCaster.Live;

/// <summary>The picture of the user's own program: a watched file, or one that was dropped on the page.</summary>
internal sealed class MinePicture : IDisposable
{
    /// <summary>How long a file must be broken before it is reported: the user's program may still be writing it.</summary>
    private const int PatienceMilliseconds = 300;

    private readonly Lock sync = new();
    private readonly FileWatch watch = new();
    private readonly CancellationTokenSource end = new();
    private readonly string? path;
    private (int Version, string? Name, Picture? Picture, string? Problem) now;
    private (SceneState? State, int Version, Task<Comparison>? Comparison) last;

    /// <param name="path">The file to watch; null for none.</param>
    public MinePicture(string? path)
    {
        this.path = path;
        if (path is null) return;
        watch.Watch([Path.GetFullPath(path)]);
        Put(path, Read(path));
    }

    /// <summary>Called when the picture changes, or is taken away.</summary>
    public event Action? Changed;

    /// <summary>Follows the file until the end.</summary>
    public async Task FollowAsync()
    {
        if (path is null) return;
        while (!end.IsCancellationRequested)
        {
            await watch.WaitAsync(Timeout.Infinite, end.Token);
            var read = Read(path);
            while (read.Picture is null && await watch.WaitAsync(PatienceMilliseconds, end.Token)) read = Read(path);
            Put(path, read);
        }
    }

    /// <summary>Takes a picture that was dropped on the page.</summary>
    /// <param name="mostPixels">The most pixels that its header may promise.</param>
    /// <exception cref="PictureFileException">The file is no picture, or too large.</exception>
    public void Take(string name, Stream bytes, long mostPixels) => Put(name, (PictureFile.Read(bytes, 3 * mostPixels), null));

    public void Forget() => Put(null, default);

    /// <summary>The picture, if it has a camera's size; otherwise null.</summary>
    public Picture? PictureFor(Camera camera)
    {
        var picture = now.Picture;
        return (picture?.Width, picture?.Height) == (camera.Width, camera.Height) ? picture : null;
    }

    /// <summary>Compares with a scene's picture, once for all pages.</summary>
    public Task<Comparison> CompareAsync(LiveScene live, SceneState state, Studio studio)
    {
        lock (sync)
        {
            var (version, name, picture, problem) = now;
            if (!ReferenceEquals(last.State, state) || last.Version != version)
                last = (state, version, Task.Run(() => CompareAsync(new(name, problem, null, state.Scene, live.Path), picture, studio)));
            return last.Comparison!;
        }
    }

    public void Dispose()
    {
        end.Cancel();
        watch.Dispose();
    }

    private async Task<Comparison> CompareAsync(Comparison comparison, Picture? picture, Studio studio)
    {
        if (picture is null || comparison.Scene is not { } scene) return comparison;
        if (View.SizeOf(scene.Camera) != (scene.Camera.Width, scene.Camera.Height))
            return comparison with { Problem = $"the page compares at most {View.MostPixels:N0} pixels; use \"raycaster compare\"" };
        var result = await studio.DoAsync(() => new PictureComparison(picture, Renderer.Render(scene), scene), end.Token);
        return comparison with { Result = result };
    }

    private static (Picture? Picture, string? Problem) Read(string path)
    {
        try
        {
            return (PictureFile.Read(path), null);
        }
        catch (PictureFileException e)
        {
            return (null, e.Message);
        }
    }

    private void Put(string? name, (Picture? Picture, string? Problem) read)
    {
        lock (sync) now = (now.Version + 1, name, read.Picture, read.Problem);
        Changed?.Invoke();
    }
}
