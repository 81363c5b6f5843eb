using System.Collections.Concurrent;
using System.Runtime.ExceptionServices;
using System.Text.Json;

namespace RayCaster.Teaching;

/// <summary>Marks the submissions of a class, and writes a table, a page for each student, and a page for the teacher.</summary>
public sealed class ClassMarks
{
    /// <summary>
    /// The folder of finished marks, from which an interrupted run continues. They name mistakes, so they are not in the students' folders.
    /// </summary>
    private const string Kept = ".kept";

    private const string TableFile = "marks.csv";
    private const string PageFile = "class.html";

    private readonly Rubric rubric;
    private readonly string output;
    private readonly SubmissionRunner runner;
    private readonly Marker marker;
    private readonly OtherFiles others;

    private ClassMarks(Rubric rubric, string submissions, string output)
    {
        (this.rubric, this.output) = (rubric, output);
        runner = new(rubric, new(rubric.Source.Run.Count > 0 ? Containment.Here : Containment.None));
        marker = new(rubric);
        others = new([rubric.Path, .. rubric.Scenes.Select(scene => scene.Path)], submissions);
    }

    /// <summary>Options for marking a class.</summary>
    /// <param name="Threads">How many submissions are marked at the same time.</param>
    /// <param name="Resume">Whether to keep finished marks if neither rubric nor submission has changed.</param>
    /// <param name="JUnit">A file for the marks as JUnit XML, which continuous integration reads; null for none.</param>
    /// <param name="Progress">Called with the number of finished submissions and the number of all.</param>
    /// <param name="Notice">Called with what the teacher must know besides the marks.</param>
    public sealed record Options(
        int Threads, bool Resume = false, string? JUnit = null, Action<int, int>? Progress = null, Action<string>? Notice = null);

    /// <summary>Marks all submissions in a folder.</summary>
    /// <param name="submissions">A folder that contains a folder for each student.</param>
    /// <param name="output">The folder for the results; made if it does not exist.</param>
    /// <param name="cancellation">Ends the work; finished marks are kept for <see cref="Options.Resume"/>.</param>
    /// <returns>The marks in the order of the students' names.</returns>
    /// <exception cref="ProblemException">A folder cannot be read, or a file not be written.</exception>
    public static IReadOnlyList<StudentMarks> Mark(Rubric rubric, string submissions, string output, Options options, CancellationToken cancellation)
    {
        var all = Submission.In(submissions);
        RefuseSharedPlaces(all, submissions, output);
        if (Submission.LooseFiles(submissions) is [var loose, .. var more])
            options.Notice?.Invoke($"a submission is a folder, so {PrintableText.Of(Path.Combine(submissions, loose))}" +
                (more.Length == 0 ? " is not marked" : $" and {more.Length} more are not marked"));
        var marks = new ClassMarks(rubric, submissions, output);
        var done = new ConcurrentDictionary<string, StudentMarks>();
        try
        {
            Parallel.ForEach(Partitioner.Create(all, EnumerablePartitionerOptions.NoBuffering),
                new() { MaxDegreeOfParallelism = options.Threads, CancellationToken = cancellation }, submission =>
                {
                    done[submission.Student] = marks.MarkOne(submission, options.Resume, cancellation);
                    options.Progress?.Invoke(done.Count, all.Count);
                });
        }
        catch (AggregateException several)
        {
            ExceptionDispatchInfo.Throw(several.InnerExceptions[0]);
        }
        StudentMarks[] inOrder = [.. all.Select(submission => done[submission.Student])];
        if (KeepEditedTable(output) is { } copy)
            options.Notice?.Invoke($"{TableFile} was edited since the last run; that table is now {copy}");
        var table = MarksTable.Of(rubric, inOrder);
        Write(Path.Combine(output, TableFile), table);
        Write(Path.Combine(output, Kept, TableFile), table);
        Write(Path.Combine(output, PageFile), ClassPage.Of(rubric, inOrder));
        if (options.JUnit is { } file) Write(file, JUnitReport.Of(rubric, inOrder));
        return inOrder;
    }

    /// <summary>Marks and submissions must not write to the same place, which would show only after all programs have run.</summary>
    private static void RefuseSharedPlaces(IReadOnlyList<Submission> all, string submissions, string output)
    {
        var above = Path.GetFullPath(submissions).TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar;
        if ((Path.GetFullPath(output) + Path.DirectorySeparatorChar).StartsWith(above, StringComparison.OrdinalIgnoreCase))
            throw new ProblemException($"the marks cannot go to {output}, which is in the folder of submissions: name a folder outside it");
        if (File.Exists(output)) throw new ProblemException($"the marks cannot go to {output}, which is a file: name a folder");
        foreach (var submission in all)
            if (submission.Student.ToLowerInvariant() is TableFile or PageFile)
                throw new ProblemException($"the submission '{submission.Student}' is named like a file of the marks: rename the folder");
    }

    /// <summary>Copies the table of the last run if it is no longer the one that was written: it may hold points that the teacher has
    /// decided.</summary>
    /// <returns>The copy's path; null if the table was not edited.</returns>
    private static string? KeepEditedTable(string output)
    {
        var (table, written) = (Path.Combine(output, TableFile), Path.Combine(output, Kept, TableFile));
        if (!File.Exists(table)) return null;
        var bytes = File.ReadAllBytes(table); // in whatever encoding a spreadsheet has saved it
        if (File.Exists(written) && File.ReadAllBytes(written).AsSpan().SequenceEqual(bytes)) return null;
        var places = from number in Enumerable.Range(1, int.MaxValue - 1) select Path.Combine(output, $"marks-edited-{number}.csv");
        var place = places.First(place => !File.Exists(place));
        Write(place, bytes);
        return place;
    }

    private StudentMarks MarkOne(Submission submission, bool resume, CancellationToken cancellation)
    {
        var folder = Path.Combine(output, submission.Student);
        var digest = rubric.Digest + submission.Digest();
        var keptPath = Path.Combine(output, Kept, submission.Student + ".json");
        if (resume && ReadKept(keptPath) is { } kept && kept.Digest == digest && kept.Student == submission.Student) return kept;

        IReadOnlyList<SubmittedPicture> pictures;
        string[] changed = [];
        if (rubric.Source.Run.Count == 0) pictures = runner.Pictures(submission, cancellation);
        else
        {
            using var watch = others.WatchWhile(submission);
            pictures = runner.Pictures(submission, cancellation);
            changed = [.. watch.Changed()];
        }
        cancellation.ThrowIfCancellationRequested();
        var marks = marker.Mark(submission.Student, digest, pictures, changed);
        Write(Path.Combine(folder, "feedback.html"), FeedbackPage.Of(rubric, marks, pictures));
        Write(keptPath, JsonSerializer.Serialize(marks, KeptMarks.Default.StudentMarks));
        return marks;
    }

    private static StudentMarks? ReadKept(string path)
    {
        try
        {
            return File.Exists(path) ? JsonSerializer.Deserialize(File.ReadAllBytes(path), KeptMarks.Default.StudentMarks) : null;
        }
        catch (Exception e) when (e is JsonException or IOException or UnauthorizedAccessException or NotSupportedException)
        {
            return null; // a damaged file, or one of an older version, counts as missing
        }
    }

    private static void Write(string path, string text) => Write(path, Encoding.UTF8.GetBytes(text));

    /// <summary>Writes a file, and makes its folder: a student's program may have deleted it.</summary>
    private static void Write(string path, byte[] bytes)
    {
        WorkFolder.Make(Path.GetDirectoryName(Path.GetFullPath(path))!);
        WrittenFiles.Write(path, file => file.Write(bytes));
    }
}
