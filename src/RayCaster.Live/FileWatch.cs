namespace RayCaster.Live;

/// <summary>
/// Reports that one of some files may have changed. The system notifies within a millisecond. Where it does not, as on many network drives,
/// times and lengths of the files are compared a few times a second.
/// </summary>
internal sealed class FileWatch
{
    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(250);

    private readonly SemaphoreSlim changes = new(0, 1);
    private readonly Dictionary<string, FileSystemWatcher?> folders = [];
    private readonly CancellationToken end;
    private Dictionary<string, (DateTime, long)> stamps = [];

    public FileWatch(CancellationToken end)
    {
        this.end = end;
        var poll = new Timer(_ => Poll(), null, PollInterval, PollInterval);
        end.Register(() =>
        {
            poll.Dispose();
            lock (folders)
                foreach (var watcher in folders.Values) watcher?.Dispose();
        });
    }

    /// <summary>Chooses the files to watch from now on, by their full paths. Of a link, the file that it leads to is watched, too.</summary>
    public void Watch(IEnumerable<string> files)
    {
        lock (folders)
        {
            stamps = files.SelectMany(file => (string[])[file, TargetOf(file)]).Distinct().ToDictionary(
                file => file, file => stamps.TryGetValue(file, out var known) ? known : StampOf(file));
            var parents = stamps.Keys.Select(file => Path.GetDirectoryName(file)!).ToHashSet();
            foreach (var gone in folders.Keys.Except(parents).ToArray())
            {
                folders[gone]?.Dispose();
                folders.Remove(gone);
            }
            foreach (var folder in parents) folders.TryAdd(folder, Open(folder));
        }
    }

    /// <summary>Waits until a file may have changed, or until the time is over; false in that case.</summary>
    public Task<bool> WaitAsync(TimeSpan? time = null) => changes.WaitAsync(time ?? Timeout.InfiniteTimeSpan, end);

    /// <summary>The file that a link leads to; the path itself if it is no link, or leads nowhere.</summary>
    public static string TargetOf(string file)
    {
        try
        {
            return File.ResolveLinkTarget(file, returnFinalTarget: true)?.FullName ?? file;
        }
        catch (IOException)
        {
            return file;
        }
    }

    /// <summary>Watches a folder; null where the system cannot, and only <see cref="Poll"/> sees changes.</summary>
    private FileSystemWatcher? Open(string folder)
    {
        try
        {
            var watcher = new FileSystemWatcher(folder);
            watcher.Changed += (_, e) => Notice(e.FullPath);
            watcher.Created += (_, e) => Notice(e.FullPath);
            watcher.Deleted += (_, e) => Notice(e.FullPath);
            watcher.Renamed += (_, e) => Notice(e.FullPath);
            watcher.EnableRaisingEvents = true;
            return watcher;
        }
        catch (Exception e) when (e is IOException or ArgumentException or UnauthorizedAccessException)
        {
            return null;
        }
    }

    private void Notice(string file)
    {
        lock (folders)
            if (!stamps.ContainsKey(file)) return;
        Signal();
    }

    private void Poll()
    {
        var changed = false;
        lock (folders)
        {
            foreach (var (file, known) in stamps.ToArray())
            {
                stamps[file] = StampOf(file);
                changed |= stamps[file] != known;
            }
        }
        if (changed) Signal();
    }

    private void Signal()
    {
        lock (changes)
            if (changes.CurrentCount == 0) changes.Release();
    }

    /// <summary>When a file was written, and its length: −1 for a file that is not there.</summary>
    public static (DateTime Time, long Length) StampOf(string file) =>
        new FileInfo(TargetOf(file)) is { Exists: true } info ? (info.LastWriteTimeUtc, info.Length) : (default, -1);

    /// <summary>Whether a file holds nothing. A pipe has no length either: to read it might take for ever.</summary>
    public static bool IsEmpty(string file) => StampOf(file).Length == 0;
}
