namespace RayCaster.Ci;

/// <summary>
/// What the runs that have passed leave for the next: a file for each commit, with the names of the tests that failed at first. It lies in
/// $XDG_CACHE_HOME/raycaster-ci, which a workflow may keep. In a clean clone on a new machine there is none.
/// </summary>
/// <param name="folder">Where the files are.</param>
internal sealed class Record(string folder)
{
    private const int Most = 50;

    /// <summary>The folder in the user's cache.</summary>
    public static Record OfUser()
    {
        var cache = Environment.GetEnvironmentVariable("XDG_CACHE_HOME");
        if (string.IsNullOrEmpty(cache)) cache = Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache");
        return new(Path.Combine(cache, "raycaster-ci"));
    }

    /// <summary>The nearest commit that has passed.</summary>
    /// <param name="ancestors">The commits before this one, the nearest first.</param>
    public string? LastPassed(IEnumerable<string> ancestors) => ancestors.FirstOrDefault(commit => File.Exists(FileOf(commit)));

    /// <summary>The names of the tests that failed at first in the run of a commit.</summary>
    public IReadOnlyCollection<string> FailedAtFirst(string? commit) => commit is null ? [] : File.ReadAllLines(FileOf(commit));

    /// <summary>Writes the names for a commit, and deletes the oldest files.</summary>
    public void Write(string commit, IEnumerable<string> failedAtFirst)
    {
        Directory.CreateDirectory(folder);
        File.WriteAllLines(FileOf(commit), failedAtFirst.Order());
        foreach (var old in new DirectoryInfo(folder).GetFiles("*.txt").OrderByDescending(file => file.LastWriteTimeUtc).Skip(Most)) old.Delete();
    }

    private string FileOf(string commit) => Path.Combine(folder, commit + ".txt");
}
