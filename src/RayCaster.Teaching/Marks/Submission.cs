using System.IO.Enumeration;
using System.Security.Cryptography;

namespace RayCaster.Teaching;

/// <summary>A student's work: a folder that is named after the student.</summary>
/// <param name="Folder">The folder, as a full path.</param>
internal sealed record Submission(string Folder)
{
    /// <summary>Folders that building makes, and others that are not the student's work.</summary>
    private static readonly string[] leftOut = ["bin", "obj", "node_modules"];

    private static readonly EnumerationOptions files =
        new() { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint, MaxRecursionDepth = 32 };

    public string Student => Path.GetFileName(Folder);

    /// <summary>The submissions in a folder: each folder in it is one. Sorted by name.</summary>
    /// <exception cref="ProblemException">
    /// The folder cannot be listed, contains no folder, or contains a name with an invisible character.
    /// </exception>
    public static IReadOnlyList<Submission> In(string folder)
    {
        if (File.Exists(folder)) throw new ProblemException($"{folder} is a file: name the folder that contains a folder for each student");
        try
        {
            Submission[] all =
            [
                .. Directory.EnumerateDirectories(Path.GetFullPath(folder)).Where(path => !Path.GetFileName(path).StartsWith('.'))
                    .Order(StringComparer.Ordinal).Select(path => new Submission(path)),
            ];
            if (all.Length == 0)
            {
                var loose = LooseFiles(folder).Length;
                throw new ProblemException($"no submissions in {folder}: it contains no folders and {loose} file{(loose == 1 ? "" : "s")}, " +
                    "but must contain a folder for each student, named after the student");
            }
            foreach (var submission in all)
                if (!submission.Student.All(PrintableText.IsPrintable))
                    throw new ProblemException(
                        $"the submission '{PrintableText.Of(submission.Student)}' has an invisible character in its name: rename the folder");
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

    /// <summary>A hash of the names, lengths and times of the submission's files; files that building makes are left out.</summary>
    public string Digest()
    {
        var lines = State(Folder).Where(file => !IsLeftOut(file.Path)).OrderBy(file => file.Path, StringComparer.Ordinal)
            .Select(file => $"{Path.GetRelativePath(Folder, file.Path)}|{file.State.Length} {file.State.Time.Ticks}\n");
        return Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(string.Concat(lines))));
    }

    /// <summary>The files below a folder, each with its length and the time of its last change.</summary>
    public static IReadOnlyList<(string Path, (long Length, DateTime Time) State)> State(string folder)
    {
        var found = new List<(string, (long, DateTime))>();
        try
        {
            found.AddRange(new FileSystemEnumerable<(string, (long, DateTime))>(
                folder, (ref entry) => (entry.ToFullPath(), (entry.Length, entry.LastWriteTimeUtc.UtcDateTime)), files)
            { ShouldIncludePredicate = (ref entry) => !entry.IsDirectory });
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // A folder was deleted meanwhile.
        }
        return found;
    }

    private bool IsLeftOut(string path) =>
        Path.GetRelativePath(Folder, path).Split(Path.DirectorySeparatorChar)
            .Any(part => leftOut.Contains(part) || (part.StartsWith('.') && part.Length > 1));
}
