namespace RayCaster.Marks;

/// <summary>A student's work: a folder of pictures and test results that is named after the student.</summary>
/// <param name="Folder">The folder, as a full path.</param>
internal sealed record Submission(string Folder)
{
    /// <summary>How many other files a message names if a picture is missing, and how many files are searched.</summary>
    private const int MaxNamed = 3, MaxSearched = 10_000;

    /// <summary>Stands for a scene's name in the path of its picture.</summary>
    public const string Name = "{name}";

    /// <summary>What may be a picture of another name or kind, or hold pictures.</summary>
    private static readonly string[] likeAPicture =
        [".png", ".ppm", ".jpg", ".jpeg", ".bmp", ".gif", ".tif", ".tiff", ".webp", ".zip", ".rar", ".7z", ".gz", ".tar"];

    private static readonly EnumerationOptions withoutLinks =
        new() { RecurseSubdirectories = true, AttributesToSkip = FileAttributes.ReparsePoint, MaxRecursionDepth = 16 };

    public string Student => Path.GetFileName(Folder);

    /// <summary>The submissions in a folder: each folder in it is one. Sorted by name.</summary>
    /// <exception cref="ProblemException">There are none, they are a folder above or below, or their names cannot be told apart.</exception>
    public static IReadOnlyList<Submission> In(string folder, Rubric rubric)
    {
        if (!Directory.Exists(folder)) throw new ProblemException($"{folder} is no folder: name the one that contains a folder for each student");
        var whole = new Submission(Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder)));
        Submission[] all = [.. whole.Below().OrderBy(submission => submission.Student, StringComparer.Ordinal)];
        if (!all.Any(submission => submission.HasPicture(rubric))) RefuseWrongFolder(folder, whole, all, rubric);
        if (all.FirstOrDefault(submission => !submission.Student.All(PrintableText.IsPrintable)) is { } odd)
            throw new ProblemException($"the submission '{PrintableText.From(odd.Student)}' has an invisible character in its name: rename it");
        foreach (var (i, submission) in all.Index())
            if (all.Skip(i + 1).FirstOrDefault(other => AreEquivalent(submission.Student, other.Student)) is { } other)
                throw new ProblemException($"the submissions '{submission.Student}' and '{other.Student}' differ only " +
                    (submission.Student.Length == other.Student.Length ? "by case" : "in how accents are encoded") +
                    ": on some systems their pages would be the same file, so rename one");
        return all;
    }

    /// <summary>The names of the files in a folder of submissions, perhaps archives that nobody has unpacked.</summary>
    public static string[] LooseFiles(string folder) =>
    [
        .. Directory.EnumerateFiles(folder).Select(path => Path.GetFileName(path)).Where(name => !name.StartsWith('.'))
            .Order(StringComparer.Ordinal),
    ];

    /// <summary>The pictures, one for each scene of the rubric: each is a picture, or the reason why there is none.</summary>
    public IReadOnlyList<SubmittedPicture> Pictures(Rubric rubric)
    {
        if (LinkIn(Folder) is not null) return None(rubric, "the student's folder is a link, which may lead to another student's");
        var missing = new Lazy<string>(() => MissingPicture(rubric));
        return [.. rubric.Scenes.Select(scene => Read(scene))];

        SubmittedPicture Read(MarkedScene scene)
        {
            var file = PathOf(scene, rubric);
            if (LinkIn(file) is { } link) return new(scene, null, $"{link} is a link: the picture must be in the student's folder");
            return File.Exists(Path.Combine(Folder, file)) ? SubmittedPicture.Read(scene, Path.Combine(Folder, file))
                : new(scene, null, missing.Value);
        }
    }

    /// <summary>No picture of any scene, for one reason.</summary>
    public static IReadOnlyList<SubmittedPicture> None(Rubric rubric, string problem) =>
        [.. rubric.Scenes.Select(scene => new SubmittedPicture(scene, null, problem))];

    /// <summary>The files, or links, whose paths fit a pattern, as paths from the folder; the pattern itself if its folder is a link.</summary>
    public IReadOnlyList<string> FilesLike(string pattern)
    {
        var folder = Path.GetDirectoryName(pattern) ?? "";
        if (LinkIn(folder) is not null) return [pattern];
        return !Directory.Exists(Path.Combine(Folder, folder)) ? [] : [.. Directory.EnumerateFiles(Path.Combine(Folder, folder),
            Path.GetFileName(pattern)).Select(path => Path.GetRelativePath(Folder, path)).Order(StringComparer.Ordinal)];
    }

    private IEnumerable<Submission> Below() => Directory.EnumerateDirectories(Folder)
        .Where(path => !Path.GetFileName(path).StartsWith('.')).Select(path => new Submission(path));

    /// <summary>Whether some systems take two names for one: they differ only by case, or in how accents are encoded.</summary>
    private static bool AreEquivalent(string one, string other) => Accents.AreEquivalent(one.ToUpperInvariant(), other.ToUpperInvariant());

    /// <summary>No submission has a picture. Perhaps another folder was meant.</summary>
    private static void RefuseWrongFolder(string folder, Submission whole, Submission[] all, Rubric rubric)
    {
        if (whole.HasPicture(rubric))
            throw new ProblemException($"{folder} holds pictures itself, so it seems to be one student's: is {whole.Student} one folder too deep? " +
                "Name the folder above it");
        if (all is [var only] && only.Below().FirstOrDefault(below => below.HasPicture(rubric)) is { } student)
            throw new ProblemException($"the only folder in {folder}, {only.Student}, holds folders with pictures, such as {student.Student}: " +
                $"are these the students? Name {Path.Combine(folder, only.Student)}");
        if (all.Length > 0) return;
        var loose = LooseFiles(folder).Length;
        throw new ProblemException($"no submissions in {folder}: it contains no folders and {loose} file{(loose == 1 ? "" : "s")}, " +
            "but must contain a folder for each student, named after the student");
    }

    private bool HasPicture(Rubric rubric) => rubric.Scenes.Any(scene => File.Exists(Path.Combine(Folder, PathOf(scene, rubric))));

    /// <summary>The path of a scene's picture from the folder; that of a PPM if only this is there.</summary>
    private string PathOf(MarkedScene scene, Rubric rubric)
    {
        var file = rubric.Pictures.Replace(Name, scene.Name);
        var ppm = Path.ChangeExtension(file, ".ppm");
        return !File.Exists(Path.Combine(Folder, file)) && File.Exists(Path.Combine(Folder, ppm)) ? ppm : file;
    }

    /// <summary>The first part of a path below the folder, or the folder itself, that is a link, perhaps into somebody else's folder.</summary>
    public string? LinkIn(string path)
    {
        var parts = Path.GetRelativePath(Folder, Path.Combine(Folder, path)).Split(Path.DirectorySeparatorChar);
        return Enumerable.Range(1, parts.Length).Select(count => Path.Combine(parts[..count]))
            .FirstOrDefault(part => new FileInfo(Path.TrimEndingDirectorySeparator(Path.GetFullPath(part, Folder))).LinkTarget is not null);
    }

    /// <summary>The message that a picture of <see cref="Name"/> is missing, with the files that may be meant for it.</summary>
    private string MissingPicture(Rubric rubric)
    {
        string[] files =
            [.. Directory.EnumerateFiles(Folder, "*", withoutLinks).Take(MaxSearched).Select(path => Path.GetRelativePath(Folder, path))];
        if (files.Length == 0) return "the student's folder is empty";
        string[] others = [.. files.Except(rubric.Scenes.Select(scene => PathOf(scene, rubric)))
            .Where(file => likeAPicture.Contains(Path.GetExtension(file).ToLowerInvariant())).Order(StringComparer.Ordinal)];
        var more = others.Length > MaxNamed ? $" and {others.Length - MaxNamed} more" : "";
        return $"no picture {rubric.Pictures}" + (others.Length == 0 ? ""
            : $"; there {(others.Length == 1 ? "is" : "are")} {string.Join(", ", others.Take(MaxNamed))}{more}");
    }
}
