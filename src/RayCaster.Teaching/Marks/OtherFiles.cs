using System.Diagnostics;

namespace RayCaster.Teaching;

/// <summary>
/// The files that a student's program must not change: the scenes and the other submissions. Only a container can keep the program from
/// them, but a change is noticed. Submissions that run at the same time may change files in their own folders.
/// </summary>
/// <param name="folder">The folder of all submissions.</param>
internal sealed class OtherFiles(IReadOnlyList<string> files, string folder)
{
    private const int MaxNamed = 5;

    private readonly string folder = Path.GetFullPath(folder);
    private readonly List<Watch> watches = [];
    private Look? last;

    /// <remarks>Reading the state of all files of a large class takes long, so the state that was read last is reused as the first.</remarks>
    public Watch WatchWhile(Submission submission)
    {
        lock (watches)
        {
            var watch = new Watch(this, submission, last ??= Now());
            watches.Add(watch);
            return watch;
        }
    }

    private Look Now()
    {
        var time = Stopwatch.GetTimestamp();
        var state = Submission.State(folder).ToDictionary(file => file.Path, file => file.State);
        foreach (var path in files)
            state[path] = new FileInfo(path) is { Exists: true } file ? (file.Length, file.LastWriteTimeUtc) : default;
        return new(time, state);
    }

    internal sealed record Look(long Time, Dictionary<string, (long, DateTime)> Files);

    /// <summary>The time while a submission runs.</summary>
    internal sealed class Watch(OtherFiles all, Submission own, Look before) : IDisposable
    {
        private readonly Submission own = own; // which other watches look at
        private long ended = long.MaxValue;

        /// <summary>Ends the watch, and says what has changed outside its folder, in words; empty if nothing has.</summary>
        public IEnumerable<string> Changed()
        {
            Dispose(); // before the files are read, so that this submission does not count as one beside a later one
            var now = all.Now();
            Submission[] beside;
            lock (all.watches)
            {
                if (now.Time > all.last!.Time) all.last = now;
                beside = [.. all.watches.Where(watch => watch != this && watch.ended > before.Time).Select(watch => watch.own)];
            }
            string[] changed =
            [
                .. before.Files.Keys.Union(now.Files.Keys)
                    .Where(path => before.Files.GetValueOrDefault(path) != now.Files.GetValueOrDefault(path)
                        && !beside.Append(own).Any(other => path.StartsWith(other.Folder + Path.DirectorySeparatorChar, StringComparison.Ordinal)))
                    .Order(StringComparer.Ordinal),
            ];
            if (changed.Length == 0) yield break;
            var named = string.Join(", ", changed.Take(MaxNamed).Select(path => PrintableText.Of(Path.GetRelativePath(all.folder, path))));
            var ran = beside.Length == 0 ? "it ran" : $"it and {string.Join(", ", beside.Select(other => other.Student))} ran";
            yield return $"files outside its folder changed while {ran}: {named}" +
                $"{(changed.Length > MaxNamed ? $" and {changed.Length - MaxNamed} more" : "")}";
        }

        public void Dispose()
        {
            lock (all.watches) ended = Math.Min(ended, Stopwatch.GetTimestamp());
        }
    }
}
