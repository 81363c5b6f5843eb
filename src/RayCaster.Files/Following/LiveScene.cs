namespace RayCaster.Files;

/// <summary>What a scene file says now, and the last scene that it said without a mistake.</summary>
/// <param name="Version">Counts the changes, from 1.</param>
/// <param name="Text">The file's bytes as they were read; empty where it could not be read.</param>
/// <param name="Problems">What is wrong with the file now.</param>
/// <param name="Scene">The last good scene; null if there was none.</param>
/// <param name="IsGood">Whether that is what the file says now.</param>
public sealed record SceneState(int Version, byte[] Text, IReadOnlyList<Problem> Problems, Scene? Scene, bool IsGood);

/// <summary>A scene file and the meshes that it names, read again whenever one of them is saved.</summary>
public sealed class LiveScene : IDisposable
{
    /// <summary>
    /// How long a file must be broken before that is said: an editor may be in the middle of saving it. One that is empty or gone
    /// is most likely about to be written.
    /// </summary>
    private const int PatienceMilliseconds = 150, PatienceWithNothing = 600;

    private readonly FileWatch watch = new();
    private readonly string folder;
    private readonly CancellationTokenSource end = new();
    private CancellationTokenSource outdated = new();
    private (DateTime, long)[] stamps = []; // of the meshes that are shown

    /// <summary>Reads the file for the first time.</summary>
    /// <param name="path">The file as the user named it.</param>
    public LiveScene(string path)
    {
        (Path, FullPath) = (path, System.IO.Path.GetFullPath(path));
        folder = System.IO.Path.GetDirectoryName(path) ?? "";
        watch.Watch([FullPath]);
        State = Next(Read(out var text), text);
    }

    /// <summary>The file as the user named it.</summary>
    public string Path { get; }

    /// <summary>The same from the root of the file system.</summary>
    public string FullPath { get; }

    /// <summary>What the file says now.</summary>
    public SceneState State { get; private set; }

    /// <summary>Cancelled as soon as the file says something else.</summary>
    public CancellationToken Outdated => outdated.Token;

    /// <summary>Called after each change.</summary>
    public event Action? Changed;

    /// <summary>Follows the file until the end.</summary>
    public async Task FollowAsync()
    {
        while (!end.IsCancellationRequested)
        {
            await watch.WaitAsync(end.Token);
            await Task.Delay(1, end.Token); // most editors' second notice is there by then
            var (reading, text) = await ReadPatiently();
            var isSame = text.AsSpan().SequenceEqual(State.Text) && reading.Scene is not null == State.IsGood;
            if (isSame && stamps.AsSpan().SequenceEqual(StampsOf(reading))) continue; // a save tells of itself twice
            Publish(Next(reading, text));
        }
    }

    /// <summary>Writes a camera's place into the file, and nothing else.</summary>
    /// <param name="camera">The camera.</param>
    /// <param name="version">Which state of the file the user has seen.</param>
    /// <returns>Null if it is done; otherwise why not: the file says something else by now, or is broken.</returns>
    /// <exception cref="PictureFileException">It cannot be written.</exception>
    public string? WriteCamera(Camera camera, int version)
    {
        var state = State;
        if (!state.IsGood) return "the scene file has a mistake: mend it first";
        if (state.Version != version || !File.ReadAllBytes(FullPath).AsSpan().SequenceEqual(state.Text))
            return "the scene file was changed at the same time: look at it, then write again";
        using var file = new ReplacedFile(File.ResolveLinkTarget(FullPath, returnFinalTarget: true)?.FullName ?? FullPath);
        file.Write(CameraEdit.Write(state.Text, camera));
        file.Commit();
        return null;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        end.Cancel();
        watch.Dispose();
    }

    private void Publish(SceneState state)
    {
        State = state;
        Interlocked.Exchange(ref outdated, new()).Cancel();
        Changed?.Invoke();
    }

    /// <summary>Reads until the file is good, or has been broken for a while without a change.</summary>
    private async Task<(SceneReading, byte[])> ReadPatiently()
    {
        while (true)
        {
            var reading = Read(out var text);
            if (reading.Scene is not null) return (reading, text);
            var patience = text.Length == 0 ? PatienceWithNothing : PatienceMilliseconds;
            if (!await watch.WaitAsync(patience, end.Token)) return (reading, text);
        }
    }

    private SceneState Next(SceneReading reading, byte[] text)
    {
        watch.Watch([FullPath, .. reading.MeshFiles]);
        stamps = StampsOf(reading);
        return new((State?.Version ?? 0) + 1, text, reading.Problems, reading.Scene ?? State?.Scene, reading.Scene is not null);
    }

    private static (DateTime, long)[] StampsOf(SceneReading reading) => [.. reading.MeshFiles.Select(FileWatch.StampOf)];

    private SceneReading Read(out byte[] text)
    {
        try
        {
            using var file = new FileStream(FullPath, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete, bufferSize: 0);
            if (file.Length <= SceneReader.MostBytes)
            {
                text = new byte[file.Length];
                file.ReadExactly(text);
                return SceneReader.Parse(text, Path, folder);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // It is not there, or becomes shorter at this moment; the reader of files finds the words.
        }
        text = [];
        return SceneReader.Read(Path);
    }
}
