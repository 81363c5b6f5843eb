using System.Text.RegularExpressions;

namespace RayCaster.Teaching;

/// <summary>Gets the pictures of a submission: finds them in its folder, or runs its program.</summary>
internal sealed partial class SubmissionRunner(Rubric rubric, ProgramRunner runner)
{
    /// <summary>How many characters, or how many errors and characters of each, of what a program printed are quoted.</summary>
    private const int Quoted = 200, MaxErrors = 3, ErrorLength = 400;

    /// <summary>How many pictures of other names are told.</summary>
    private const int MaxPictures = 3;

    /// <summary>A program that was ended for so many scenes in a row is not run for the rest: that could take hours.</summary>
    private const int MaxEndedInARow = 2;

    /// <summary>The pictures, one for each scene of the rubric. Whatever the program does, each result is a picture or a message.</summary>
    public IReadOnlyList<SubmittedPicture> Pictures(Submission submission, CancellationToken cancellation)
    {
        var source = rubric.Source;
        if (Submission.State(submission.Folder).Count == 0) return None("the submission's folder is empty");
        if (source.Run.Count == 0) return [.. rubric.Scenes.Select(scene => Find(submission, scene))];
        if (source.Build.Count > 0 && Build(submission, cancellation) is { } problem) return None(problem);
        var pictures = new List<SubmittedPicture>();
        var ended = 0; // runs in a row that were ended
        foreach (var scene in rubric.Scenes.TakeWhile(_ => ended < MaxEndedInARow))
        {
            pictures.Add(Draw(submission, scene, cancellation, out var isEnded));
            ended = isEnded ? ended + 1 : 0;
        }
        return [.. pictures, .. None("not run: the program had to be ended at the scenes before").Skip(pictures.Count)];
    }

    /// <summary>No picture of any scene, for one reason.</summary>
    public IReadOnlyList<SubmittedPicture> None(string problem) => [.. rubric.Scenes.Select(scene => new SubmittedPicture(scene, null, problem))];

    private SubmittedPicture Find(Submission submission, MarkedScene scene)
    {
        var path = PathOf(submission, scene);
        if (LinkIn(submission.Folder, path) is { } link)
            return new(scene, null, $"{link} is a link: the picture must be in the submission's folder");
        if (File.Exists(path)) return SubmittedPicture.Read(scene, path);
        var others = Others(submission.Folder, rubric.Scenes.Select(other => PathOf(submission, other)));
        return new(scene, null, $"no picture {Path.GetRelativePath(submission.Folder, path)}{(others == "" ? "" : $"; there is {others}")}");
    }

    private string PathOf(Submission submission, MarkedScene scene) =>
        OrPpm(Path.Combine(submission.Folder, rubric.Source.Pictures.Replace("{name}", scene.Name)));

    /// <summary>The first part of a path below a folder that is a link, perhaps into somebody else's folder; null if none is.</summary>
    public static string? LinkIn(string folder, string path)
    {
        var parts = Path.GetRelativePath(folder, path).Split(Path.DirectorySeparatorChar);
        return Enumerable.Range(1, parts.Length).Select(count => string.Join(Path.DirectorySeparatorChar, parts[..count]))
            .FirstOrDefault(part => new FileInfo(Path.Combine(folder, part)).LinkTarget is not null);
    }

    /// <summary>A picture's path; that of a PPM instead if only this is there.</summary>
    private static string OrPpm(string path) =>
        !File.Exists(path) && Path.ChangeExtension(path, ".ppm") is var ppm && File.Exists(ppm) ? ppm : path;

    /// <summary>Some pictures that a folder has besides the scenes': they may be called otherwise than the rubric says.</summary>
    private static string Others(string folder, params IEnumerable<string> scenes) => string.Join(", ",
        Submission.State(folder).Select(file => file.Path).Except(scenes)
            .Where(path => Path.GetExtension(path).ToLowerInvariant() is ".png" or ".ppm")
            .Select(path => Path.GetRelativePath(folder, path)).Order(StringComparer.Ordinal).Take(MaxPictures));

    private string? Build(Submission submission, CancellationToken cancellation)
    {
        var (source, limits) = (rubric.Source, rubric.Source.Limits);
        using var work = new WorkFolder();
        var run = runner.Run(
            Words(source.Build, submission, "", "", ""), work.Place(submission.Folder, submission.Folder, Readable(source.Build)), limits,
            limits.BuildTime, cancellation);
        return run.IsDone ? null : $"it does not build: {run.InWords(limits, limits.BuildTime)}{Missing(submission)}{Quote(run, submission)}";
    }

    /// <summary>Says which path of the build command the submission does not have, and in which of its folders there is one.</summary>
    private string Missing(Submission submission)
    {
        const string folder = "{dir}/";
        var missing = rubric.Source.Build.Where(word => word.StartsWith(folder, StringComparison.Ordinal)).Select(word => word[folder.Length..])
            .FirstOrDefault(path => !Path.Exists(Path.Combine(submission.Folder, path)));
        if (missing is null) return "";
        var found = Submission.State(submission.Folder).Select(file => Path.GetRelativePath(submission.Folder, file.Path).Replace('\\', '/'))
            .FirstOrDefault(path => path.Contains($"/{missing}/", StringComparison.Ordinal));
        return $"; there is no {missing} in the submission" + (found is null ? ""
            : $", but there is {found[..(found.IndexOf($"/{missing}/", StringComparison.Ordinal) + 1)]}{missing}");
    }

    private SubmittedPicture Draw(Submission submission, MarkedScene scene, CancellationToken cancellation, out bool isEnded)
    {
        using var work = new WorkFolder(); // a new one for each run, so no picture of another scene is in it
        var (command, limits) = (rubric.Source.Run, rubric.Source.Limits);
        var output = Path.Combine(work.Files, scene.Name + ".png");
        var run = runner.Run(
            Words(command, submission, work.Copy(scene), scene.Name, output),
            work.Place(work.Files, submission.Folder, Readable(command)), limits, limits.Time, cancellation);
        isEnded = run.End is not (ProgramEnd.Exited or ProgramEnd.NotStarted);
        var note = run.IsDone ? null : run.InWords(limits, limits.Time) + Quote(run, submission);
        if (run.End != ProgramEnd.Exited) return new(scene, null, note); // the picture may be incomplete
        var picture = OrPpm(output);
        if (note is null && !File.Exists(picture))
            note = (Others(work.Files) is { Length: > 0 } others ? $"it wrote {others}, not the picture that it was told" : "it wrote no picture")
                + Quote(run, submission);
        return SubmittedPicture.Read(scene, picture, note) is var read && read.IsCopied
            ? new(scene, null, "the picture shows the scene that is handed out, not the one that was to be drawn: it is a copy") : read;
    }

    /// <summary>What the rubric lets programs read, and the files of the command itself.</summary>
    private string[] Readable(IReadOnlyList<string> command) =>
        [.. rubric.Source.Limits.Readable, .. command.Where(word => Path.IsPathFullyQualified(word))];

    /// <remarks>In one pass, since a folder may be called <c>{out}</c>.</remarks>
    private static string[] Words(IReadOnlyList<string> command, Submission submission, string scene, string name, string output) =>
    [
        .. command.Select(word => Place().Replace(word, place => place.Value switch
        {
            "{dir}" => submission.Folder,
            "{scene}" => scene,
            "{name}" => name,
            _ => output,
        })),
    ];

    /// <summary>
    /// What it printed: the lines with errors, each once, as MSBuild repeats them; without such lines the end. Paths begin in the submission's
    /// folder, since those of the teacher's machine say nothing to a student.
    /// </summary>
    private static string Quote(ProgramRun run, Submission submission)
    {
        if (run.Printed.Length == 0 || run.End == ProgramEnd.NotStarted) return "";
        var text = ProjectName().Replace(run.Printed.Replace(submission.Folder + Path.DirectorySeparatorChar, ""), "");
        var lines = text.Split('\n', StringSplitOptions.TrimEntries | StringSplitOptions.RemoveEmptyEntries);
        string[] errors =
        [
            .. lines.Where(line => IsError().IsMatch(line)).Distinct()
                .Select(line => line.Length > ErrorLength ? $"{line[..ErrorLength]} …" : line),
        ];
        if (errors.Length == 0) return $"; it printed: {(text.Length > Quoted ? $"… {text[^Quoted..]}" : text).ReplaceLineEndings(" / ")}";
        var more = errors.Length > MaxErrors ? $" / and {errors.Length - MaxErrors} more errors" : "";
        return $"; it printed: {string.Join(" / ", errors.Take(MaxErrors))}{more}";
    }

    [GeneratedRegex(@"\{(dir|scene|out|name)\}")]
    private static partial Regex Place();

    /// <summary>The project at the end of a compiler's message.</summary>
    [GeneratedRegex(@" \[[^\]\n]*proj\]")]
    private static partial Regex ProjectName();

    [GeneratedRegex(@"\berror\b(?!\(s\))|Unhandled exception", RegexOptions.IgnoreCase)]
    private static partial Regex IsError();
}
