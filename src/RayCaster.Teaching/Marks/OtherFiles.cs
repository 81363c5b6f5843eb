namespace RayCaster.Teaching;

/// <summary>
/// The files that a student's program has no business with: the scenes and the other submissions. It cannot be kept from them without a container,
/// but what it changes there is noticed. Of programs that run at the same time each is left out of what the others are blamed for.
/// </summary>
/// <param name="files">Single files.</param>
/// <param name="folder">The folder of all submissions.</param>
internal sealed class OtherFiles(IReadOnlyList<string> files, string folder)
{
    private const int MostNamed = 5;

    private readonly string folder = Path.GetFullPath(folder);
    private readonly List<Watch> running = [];

    /// <summary>Begins to watch while a submission runs.</summary>
    public Watch WatchWhile(Submission submission)
    {
        lock (running)
        {
            var watch = new Watch(this, submission);
            foreach (var other in running)
            {
                other.Excuse(submission);
                watch.Excuse(other.Own);
            }
            running.Add(watch);
            return watch;
        }
    }

    private Dictionary<string, string> Now()
    {
        var state = Submission.State(folder).ToDictionary(file => file.Path, file => file.State);
        foreach (var path in files)
            state[path] = new FileInfo(path) is { Exists: true } file ? $"{file.Length} {file.LastWriteTimeUtc.Ticks}" : "";
        return state;
    }

    /// <summary>The time while a submission runs.</summary>
    internal sealed class Watch : IDisposable
    {
        private readonly OtherFiles all;
        private readonly Dictionary<string, string> before;
        private readonly HashSet<Submission> excused = [];

        public Watch(OtherFiles all, Submission submission)
        {
            (this.all, Own, before) = (all, submission, all.Now());
            Excuse(submission);
        }

        /// <summary>The submission that runs.</summary>
        public Submission Own { get; }

        /// <summary>Another runs at the same time, and may change its own files.</summary>
        public void Excuse(Submission other) => excused.Add(other);

        /// <summary>What has changed, in words; empty if nothing has.</summary>
        public IEnumerable<string> Changed()
        {
            var now = all.Now();
            string[] changed, beside;
            lock (all.running)
            {
                beside = [.. excused.Where(other => other != Own).Select(other => other.Student)];
                changed =
                [
                    .. before.Keys.Union(now.Keys)
                        .Where(path => !excused.Any(own => path.StartsWith(own.Folder + Path.DirectorySeparatorChar, StringComparison.Ordinal))
                            && before.GetValueOrDefault(path) != now.GetValueOrDefault(path))
                        .Order(StringComparer.Ordinal),
                ];
            }
            if (changed.Length == 0) yield break;
            var named = string.Join(", ", changed.Take(MostNamed).Select(path => Path.GetRelativePath(all.folder, path)));
            var ran = beside.Length == 0 ? "it ran" : $"it and {string.Join(", ", beside)} ran";
            yield return $"files outside its folder changed while {ran}: {named}" +
                $"{(changed.Length > MostNamed ? $" and {changed.Length - MostNamed} more" : "")}";
        }

        /// <summary>Ends the watch.</summary>
        public void Dispose()
        {
            lock (all.running) all.running.Remove(this);
        }
    }
}
