namespace RayCaster.Page;

/// <summary>The picture of the user's own program: a watched file, or one that was dropped on the page.</summary>
internal sealed class UserPicture(string? path, TimeProvider clock, CancellationToken end)
{
    /// <summary>How long a file must be broken before it is reported: the user's program may still be writing it.</summary>
    private static readonly TimeSpan GracePeriod = TimeSpan.FromMilliseconds(300);

    private readonly Lock sync = new();
    private (int Version, string? Name, Picture? Picture, string? Problem) now;
    private (SceneState? State, int Version, Comparison? Comparison) last;

    public event Action? Changed;

    public async Task FollowAsync()
    {
        if (path is null) return;
        var watch = new FileWatch(clock, end);
        ((DateTime, long) Stamp, Picture? Picture, string? Problem) known = default;
        var full = Path.GetFullPath(path);
        watch.Watch([full]);
        do
        {
            var (picture, problem) = Read(path);
            while (picture is null && await watch.WaitAsync(GracePeriod)) (picture, problem) = Read(path);
            var stamp = FileWatch.StampOf(full);
            if ((known.Stamp, known.Problem) == (stamp, problem) && IsSame(known.Picture, picture)) continue; // a second notice of the same picture
            known = (stamp, picture, problem);
            Put(path, picture, problem);
        }
        while (await watch.WaitAsync());
    }

    /// <summary>Takes a picture that was dropped, of the scene's size or a million pixels at most.</summary>
    /// <exception cref="ProblemException">The file is no picture, or too large.</exception>
    public void Take(string file, Stream bytes, Scene? scene) =>
        Put(NameOf(file), PictureFile.Read(bytes, 3 * View.PixelsOf(scene)));

    public void Forget() => Put(null, null);

    public Picture? PictureFor(Camera camera)
    {
        var picture = now.Picture;
        return (picture?.Width, picture?.Height) == (camera.Width, camera.Height) ? picture : null;
    }

    /// <summary>The comparison with a scene's picture, one for all pages.</summary>
    public Comparison CompareWith(SceneState state, string sceneName)
    {
        lock (sync)
        {
            if (ReferenceEquals(last.State, state) && last.Version == now.Version) return last.Comparison!;
            var scene = state.Scene!;
            var isTooLarge = now.Picture is not null && View.SizeOf(scene.Camera) != (scene.Camera.Width, scene.Camera.Height);
            var problem = isTooLarge ? $"the page compares at most {View.MaxPixels:N0} pixels; use \"raycaster compare\"" : now.Problem;
            last = (state, now.Version, new(now.Name, problem, isTooLarge ? null : now.Picture, scene, sceneName));
            return last.Comparison;
        }
    }

    private static string NameOf(string text)
    {
        var name = PrintableText.From(Path.GetFileName(text.Replace('\\', '/')));
        return name.Length == 0 ? "your picture" : name[..Math.Min(100, name.Length)];
    }

    private static bool IsSame(Picture? a, Picture? b) =>
        (a?.Width, a?.Height) == (b?.Width, b?.Height) && (a is null || a.Rgb.AsSpan().SequenceEqual(b!.Rgb));

    private static (Picture? Picture, string? Problem) Read(string path)
    {
        try
        {
            return FileWatch.IsEmpty(path) ? (null, $"{path} is empty") : (PictureFile.Read(path), null);
        }
        catch (ProblemException e)
        {
            return (null, e.Message);
        }
        catch (Exception unexpected)
        {
            return (null, Fault.InWords("raycaster-live", unexpected));
        }
    }

    private void Put(string? name, Picture? picture, string? problem = null)
    {
        lock (sync) now = (now.Version + 1, name, picture, problem);
        Changed?.Invoke();
    }
}
