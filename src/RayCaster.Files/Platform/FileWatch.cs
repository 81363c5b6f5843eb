namespace RayCaster.Files;

/// <summary>Notices that one of some files has changed: compares their times and lengths, which works on every file system.</summary>
/// <remarks>Two saves of the same length may have the same time: that of FAT counts in steps of two seconds. So a file also counts as changed once,
/// when its time is <see cref="TimeStep"/> old.</remarks>
internal sealed class FileWatch(TimeProvider clock, CancellationToken end)
{
    private static readonly TimeSpan PollInterval = TimeSpan.FromMilliseconds(30), TimeStep = TimeSpan.FromSeconds(2);

    private Dictionary<string, (DateTime, long, bool IsOld)> stamps = [];

    /// <summary>Chooses the files to watch from now on. Of a link, the file that it leads to is watched.</summary>
    public void Watch(IEnumerable<string> files) =>
        stamps = files.Distinct().ToDictionary(file => file, file => stamps.TryGetValue(file, out var known) ? known : AgedStampOf(file));

    /// <summary>Waits until a file has changed, or until the time is over; false in that case.</summary>
    public async Task<bool> WaitAsync(TimeSpan? time = null)
    {
        var start = clock.GetTimestamp();
        while (!HasChanged())
        {
            if (clock.GetElapsedTime(start) > time) return false;
            await Task.Delay(PollInterval, clock, end);
        }
        return true;
    }

    /// <summary>When a file was written, and its length: −1 for a file that is not there or cannot be looked at, −2 for a folder.</summary>
    public static (DateTime Time, long Length) StampOf(string file) =>
        new FileInfo((new FileInfo(file).LinkTarget is null ? null : PathResolver.Resolve(file)) ?? file) is { Exists: true } info
            ? (info.LastWriteTimeUtc, info.Length) : (default, Directory.Exists(file) ? -2 : -1);

    /// <summary>Whether a file holds nothing. A pipe has no length either: to read it might take for ever.</summary>
    public static bool IsEmpty(string file) => StampOf(file).Length == 0;

    private (DateTime, long, bool) AgedStampOf(string file)
    {
        var (time, length) = StampOf(file);
        return (time, length, clock.GetUtcNow().UtcDateTime - time > TimeStep);
    }

    private bool HasChanged()
    {
        var before = stamps;
        stamps = before.Keys.ToDictionary(file => file, AgedStampOf);
        return before.Any(file => stamps[file.Key] != file.Value);
    }
}
