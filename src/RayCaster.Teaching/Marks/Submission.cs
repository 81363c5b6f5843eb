using System.IO.Enumeration;
using System.Security.Cryptography;

namespace RayCaster.Teaching;

/// <summary>A student's work: a folder that is named after the student.</summary>
/// <param name="Folder">The folder, as a full path.</param>
internal sealed record Submission(string Folder)
{
    /// <summary>The longest name of a folder, in bytes: files are named after it, with endings, and a name has 255 bytes at most.</summary>
    private const int MaxNameBytes = 200;

    /// <summary>The marks of a submission with more bytes than this are not kept for the next run.</summary>
    private const long MaxHashedBytes = 1 << 28;

    private static readonly EnumerationOptions files =
        new() { RecurseSubdirectories = true, AttributesToSkip = 0, MaxRecursionDepth = 64 };

    /// <summary>What the student is called in place of the folder's name; null for none.</summary>
    public string? Id { get; init; }

    /// <summary>The name of rows and pages: the id, or the folder's name.</summary>
    public string Student => Id ?? Path.GetFileName(Folder);

    /// <summary>The submissions in a folder: each folder in it is one. Sorted by name.</summary>
    /// <param name="ids">The students' ids by folder; a folder without one keeps its name.</param>
    /// <exception cref="ProblemException">
    /// The folder cannot be listed, contains no folder, or contains a name with an invisible character.
    /// </exception>
    public static IReadOnlyList<Submission> In(string folder, IReadOnlyDictionary<string, string> ids)
    {
        if (File.Exists(folder)) throw new ProblemException($"{folder} is a file: name the folder that contains a folder for each student");
        try
        {
            Submission[] all =
            [
                .. Directory.EnumerateDirectories(Path.GetFullPath(folder)).Where(path => !Path.GetFileName(path).StartsWith('.'))
                    .Order(StringComparer.Ordinal).Select(path => new Submission(path) { Id = ids.GetValueOrDefault(Path.GetFileName(path)) }),
            ];
            if (all.Length == 0)
            {
                var loose = LooseFiles(folder).Length;
                throw new ProblemException($"no submissions in {folder}: it contains no folders and {loose} file{(loose == 1 ? "" : "s")}, " +
                    "but must contain a folder for each student, named after the student");
            }
            foreach (var submission in all)
            {
                if (!submission.Student.All(PrintableText.IsPrintable))
                    throw new ProblemException(
                        $"the submission '{PrintableText.Of(submission.Student)}' has an invisible character in its name: rename it");
                if (submission.Student.AsSpan().ContainsAny('/', '\\') || submission.Student is ['.', ..])
                    throw new ProblemException($"the id '{submission.Student}' cannot name a folder: choose another one");
                if (submission.Id is { } id && all.Any(other => other != submission && other.Student == id))
                    throw new ProblemException($"the id '{id}' is also the name of another submission: choose another one");
                if (Encoding.UTF8.GetByteCount(submission.Student) is > MaxNameBytes and var bytes)
                    throw new ProblemException(
                        $"the submission '{submission.Student}' has a name of {bytes} bytes, the limit is {MaxNameBytes}: rename it");
            }
            return all;
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            throw new ProblemException($"cannot read the folder of submissions {folder}: {ProblemException.Reason(e)}", e);
        }
    }

    /// <summary>The names of the files in a folder of submissions, perhaps archives that nobody has unpacked.</summary>
    public static string[] LooseFiles(string folder) =>
    [
        .. Directory.EnumerateFiles(folder).Select(path => Path.GetFileName(path)).Where(name => !name.StartsWith('.'))
            .Order(StringComparer.Ordinal),
    ];

    /// <summary>A hash of the names and contents of all its files, and of where links lead; null if there is too much to read.</summary>
    public string? Digest()
    {
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        var left = MaxHashedBytes;
        foreach (var (path, (length, _)) in State(Folder).OrderBy(file => file.Path, StringComparer.Ordinal))
        {
            var link = new FileInfo(path).LinkTarget;
            hash.AppendData(Encoding.UTF8.GetBytes($"{Path.GetRelativePath(Folder, path)}\0{link}\0{length}\0"));
            if (link is not null) continue;
            if ((left -= length) < 0 || RegularFile.Read(path, MaxHashedBytes) is not { } content) return null;
            hash.AppendData(content);
        }
        return Convert.ToHexStringLower(hash.GetHashAndReset());
    }

    /// <summary>The files below a folder, each with its length and the time of its last change.</summary>
    public static IReadOnlyList<(string Path, (long Length, DateTime Time) State)> State(string folder)
    {
        var found = new List<(string, (long, DateTime))>();
        try
        {
            found.AddRange(new FileSystemEnumerable<(string, (long, DateTime))>(
                folder, (ref entry) => (entry.ToFullPath(), (entry.Length, entry.LastWriteTimeUtc.UtcDateTime)), files)
            {
                ShouldIncludePredicate = (ref entry) => !entry.IsDirectory || IsLink(entry),
                ShouldRecursePredicate = (ref entry) => !IsLink(entry),
            });
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A folder was deleted meanwhile.
        }
        return found;
    }

    private static bool IsLink(in FileSystemEntry entry) => entry.Attributes.HasFlag(FileAttributes.ReparsePoint);
}
