namespace RayCaster.Page;

/// <summary>A scene file as it is now, and the last scene that it described without an error.</summary>
/// <param name="Version">Counts the changes, from 1.</param>
/// <param name="Text">The file's bytes; empty if it could not be read.</param>
/// <param name="Scene">The last good scene; null if there was none.</param>
/// <param name="IsGood">Whether the file describes that scene now.</param>
internal sealed record SceneState(
    int Version, ReadOnlyMemory<byte> Text, IReadOnlyList<Problem> Problems, Scene? Scene, bool IsGood);

/// <summary>Reads a scene file again whenever it, or a mesh that it names, is saved.</summary>
internal sealed class LiveScene
{
    /// <summary>
    /// How long a file must be broken before it is reported: an editor may be saving it. A file that is empty or missing is most likely about to
    /// be written.
    /// </summary>
    private static readonly TimeSpan GracePeriod = TimeSpan.FromMilliseconds(150), GracePeriodIfEmpty = TimeSpan.FromMilliseconds(600);

    private readonly TimeProvider clock;
    private readonly FileWatch watch;
    private CancellationTokenSource outdated = new();
    private (DateTime, long)[] stamps = []; // of the meshes that are shown

    public LiveScene(string path, TimeProvider clock, CancellationToken end)
    {
        Path = path;
        this.clock = clock;
        watch = new(clock, end);
        watch.Watch([FullPath]);
        State = Next(Read());
    }

    /// <summary>The file as the user named it.</summary>
    public string Path { get; private set; }

    public string FullPath => System.IO.Path.GetFullPath(Path);

    public SceneState State { get; private set; }

    /// <summary>Cancelled as soon as the file changes.</summary>
    public CancellationToken Outdated => outdated.Token;

    public event Action? Changed, Written; // Written: a camera into the file

    public async Task FollowAsync()
    {
        while (await watch.WaitAsync())
        {
            await Task.Delay(TimeSpan.FromMilliseconds(1), clock); // most editors cause a second notice within this time
            try
            {
                var reading = await ReadPatiently();
                var isSame = reading.Text.Span.SequenceEqual(State.Text.Span) && reading.Problems.SequenceEqual(State.Problems);
                if (isSame && stamps.AsSpan().SequenceEqual(StampsOf(reading))) continue; // a second notice of the same save
                State = Next(reading);
            }
            catch (Exception unexpected) when (unexpected is not OperationCanceledException)
            {
                Problem problem = new(true, Path, 0, 0, Fault.InWords("raycaster-live", unexpected), "");
                State = State with { Version = State.Version + 1, Text = default, Problems = [problem], IsGood = false };
            }
            Tell();
        }
    }

    /// <summary>Reads a file at once, the same or another one: whoever calls this has written it.</summary>
    public void ReadAgain(string path)
    {
        Path = path;
        State = Next(Read());
        Tell();
    }

    /// <summary>Writes a camera's place into the file, and nothing else.</summary>
    /// <returns>Null if it is done; otherwise the reason: the file has changed since, or is broken.</returns>
    public string? WriteCamera(Camera camera, int version)
    {
        var state = State;
        if (!state.IsGood) return "the scene file has an error: correct it first";
        const string WasChanged = "the scene file was changed at the same time: look at it, then try again";
        if (state.Version != version) return WasChanged;
        try
        {
            AtomicFile.Write(FullPath, file => file.Write(CameraEdit.Write(state.Text, camera)), () =>
            {
                // Writing to the disk takes some milliseconds, in which somebody may save the scene.
                if (!File.ReadAllBytes(FullPath).AsSpan().SequenceEqual(state.Text.Span)) throw new OperationCanceledException();
            });
            Written?.Invoke();
            return null;
        }
        catch (OperationCanceledException)
        {
            return WasChanged;
        }
    }

    /// <summary>Reads until the file is good, or stays broken for a while.</summary>
    private async Task<SceneReading> ReadPatiently()
    {
        while (true)
        {
            var reading = Read();
            if (reading.Scene is not null) return reading;
            if (!await watch.WaitAsync(reading.Text.IsEmpty ? GracePeriodIfEmpty : GracePeriod)) return reading;
        }
    }

    private SceneReading Read() => FileWatch.IsEmpty(FullPath) ? SceneReader.Parse(default, Path, "") : SceneReader.Read(Path);

    private SceneState Next(SceneReading reading)
    {
        watch.Watch([FullPath, .. reading.MeshFiles]);
        stamps = StampsOf(reading);
        var version = (State?.Version ?? 0) + 1;
        return new(version, reading.Text, reading.Problems, reading.Scene ?? State?.Scene, IsGood: reading.Scene is not null);
    }

    private void Tell()
    {
        Interlocked.Exchange(ref outdated, new()).Cancel();
        Changed?.Invoke();
    }

    private static (DateTime, long)[] StampsOf(SceneReading reading) => [.. reading.MeshFiles.Select(FileWatch.StampOf)];
}
