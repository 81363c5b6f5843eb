namespace RayCaster.Live;

/// <summary>The picture of the user's own program: a file that is watched, or one that was dropped on the page.</summary>
internal sealed class MinePicture : IDisposable
{
    /// <summary>How long a file must be broken before that is said: the user's program may be in the middle of writing it.</summary>
    private const int PatienceMilliseconds = 300;

    private readonly Lock gate = new();
    private readonly FileWatch watch = new();
    private readonly CancellationTokenSource end = new();
    private readonly string? path;
    private (int Version, string? Name, Picture? Picture, string? Problem) now;
    private (SceneState? State, Comparison? Comparison) last;

    /// <param name="path">The file; null for none.</param>
    public MinePicture(string? path)
    {
        this.path = path;
        if (path is null) return;
        watch.Watch([Path.GetFullPath(path)]);
        Put(path, Read(path));
    }

    /// <summary>Called when there is another picture, or none.</summary>
    public event Action? Changed;

    /// <summary>Follows the file until the end.</summary>
    public async Task FollowAsync()
    {
        if (path is null) return;
        while (!end.IsCancellationRequested)
        {
            await watch.WaitAsync(end.Token);
            var read = Read(path);
            while (read.Picture is null && await watch.WaitAsync(PatienceMilliseconds, end.Token)) read = Read(path);
            Put(path, read);
        }
    }

    /// <summary>Takes a picture that the page was given.</summary>
    /// <param name="name">What its file is called.</param>
    /// <param name="bytes">The file.</param>
    /// <param name="mostPixels">How large it may be, whatever its header promises.</param>
    /// <exception cref="PictureFileException">It is none, or too large.</exception>
    public void Take(string name, Stream bytes, long mostPixels) => Put(name, (PictureFile.Read(bytes, 3 * mostPixels), null));

    /// <summary>Compares no longer.</summary>
    public void Forget() => Put(null, default);

    /// <summary>The picture, if it is of a camera's size.</summary>
    public Picture? PictureFor(Camera camera)
    {
        var picture = now.Picture;
        return (picture?.Width, picture?.Height) == (camera.Width, camera.Height) ? picture : null;
    }

    /// <summary>Compares with a scene's picture; once, however many pages ask.</summary>
    public async Task<Comparison> CompareAsync(LiveScene live, SceneState state, Studio studio, CancellationToken cancellation)
    {
        var (version, name, picture, problem) = now;
        lock (gate)
            if (ReferenceEquals(last.State, state) && last.Comparison?.Version == version) return last.Comparison;
        var comparison = new Comparison(version, name, problem, null, state.Scene, live.Path);
        if (picture is not null && View.SizeOf(state.Scene!.Camera) != (state.Scene.Camera.Width, state.Scene.Camera.Height))
            comparison = comparison with { Problem = $"pictures of more than {View.MostPixels:N0} pixels are compared by \"raycaster compare\"" };
        else if (picture is not null)
            comparison = comparison with
            {
                Result = await studio.DoAsync(() => new PictureComparison(picture, Renderer.Render(state.Scene!), state.Scene), cancellation),
            };
        lock (gate) last = (state, comparison);
        return comparison;
    }

    public void Dispose()
    {
        end.Cancel();
        watch.Dispose();
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
        lock (gate) now = (now.Version + 1, name, read.Picture, read.Problem);
        Changed?.Invoke();
    }
}
