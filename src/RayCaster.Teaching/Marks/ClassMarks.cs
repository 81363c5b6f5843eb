using System.Collections.Concurrent;
using System.Diagnostics;
using System.Runtime.ExceptionServices;

namespace RayCaster.Teaching;

/// <summary>Marks the submissions of a class, and writes a table, a page for each student, and a page for the teacher.</summary>
public sealed class ClassMarks
{
    private readonly Rubric rubric;
    private readonly MarksFolder folder;
    private readonly ProgramRunner programs;
    private readonly SubmissionRunner runner;
    private readonly StepTests? tests;
    private readonly Marker marker;
    private readonly ConcurrentDictionary<string, (long Start, long End)> times = [];
    private readonly ConcurrentDictionary<string, StudentMarks> done = [];
    private readonly Dictionary<string, TeacherDecision> decisions;
    private readonly Dictionary<string, string?> digestsAtStart;

    private ClassMarks(
        Rubric rubric, IReadOnlyList<Submission> all, MarksFolder folder, Dictionary<string, TeacherDecision> decisions, Containment containment)
    {
        (this.rubric, this.folder, this.decisions) = (rubric, folder, decisions);
        programs = new(containment);
        runner = new(rubric, programs);
        tests = rubric.Tests is null ? null : new(rubric, programs);
        marker = new(rubric);
        digestsAtStart = MayChangeOthers ? all.ToDictionary(submission => submission.Student, submission => submission.Digest()) : [];
    }

    /// <summary>Options for marking a class.</summary>
    /// <param name="Threads">How many submissions are marked at the same time.</param>
    /// <param name="Resume">Whether to keep finished marks if neither rubric nor submission has changed.</param>
    /// <param name="Progress">Called with the number of finished submissions, the number of all, and who is marked next.</param>
    /// <param name="Notice">Called with what the teacher must know besides the marks.</param>
    public sealed record Options(int Threads, bool Resume = false, Action<int, int, string>? Progress = null, Action<string>? Notice = null)
    {
        /// <summary>A file with the ids by which rows and pages are named; null for the folders' names.</summary>
        public string? Ids { get; init; }

        /// <summary>The limits that the system enforces on programs; null for all that this machine offers.</summary>
        internal Containment? Containment { get; init; }
    }

    /// <summary>Whether a student's program could change the files of others.</summary>
    private bool MayChangeOthers => rubric.Source.Run.Count > 0 && !programs.IsApart;

    /// <summary>Marks all submissions in a folder.</summary>
    /// <param name="submissions">A folder that contains a folder for each student.</param>
    /// <param name="output">The folder for the results; made if it does not exist.</param>
    /// <param name="cancellation">Ends the work; finished marks are kept for <see cref="Options.Resume"/>.</param>
    /// <returns>The marks in the order of the students' names.</returns>
    /// <exception cref="ProblemException">A folder cannot be read, or a file not be written.</exception>
    public static IReadOnlyList<StudentMarks> Mark(Rubric rubric, string submissions, string output, Options options, CancellationToken cancellation)
    {
        if (Archive.Is(submissions)) submissions = Archive.Unpack(submissions, options.Notice, cancellation);
        var all = Submission.In(submissions, options.Ids is { } ids ? TeacherTable.Ids(ids) : new Dictionary<string, string>());
        if (options.Ids is not null && all.All(submission => submission.Id is null))
            throw new ProblemException(
                $"{options.Ids} has an id for none of the submissions: its first two columns must be their folders and the ids");
        RefuseSharedPlaces(all, submissions, output);
        var runs = rubric.Source.Run.Count > 0;
        if (runs) Containment.ThrowIfUnfit();
        if (Submission.LooseFiles(submissions) is [var loose, .. var more])
            options.Notice?.Invoke($"a submission is a folder, so {PrintableText.Of(Path.Combine(submissions, loose))}" +
                (more.Length == 0 ? " is not marked" : $" and {more.Length} more are not marked"));
        var decisions = TeacherTable.Decisions(Path.Combine(output, MarksFolder.Table));
        if (decisions.Count > 0)
            options.Notice?.Invoke($"{Path.Combine(output, MarksFolder.Table)}: taken from you are the points or comments of " +
                string.Join(", ", decisions.Keys.Select(student => PrintableText.Of(student))));
        var (key, files) = (MarksKey.Read(), rubric.HashOfFiles());
        if (rubric.Vary) rubric = rubric.WithVariedScenes(MarksKey.Sign(key, Encoding.UTF8.GetBytes(rubric.Digest)), options.Notice);
        var folder = new MarksFolder(output, key);
        folder.ThrowIfNotWritable();
        new ClassMarks(rubric, all, folder, decisions, runs ? options.Containment ?? Containment.Here : Containment.None)
            .MarkAll(all, options, cancellation, out var marks);
        if (rubric.HashOfFiles() != files)
            options.Notice?.Invoke($"{rubric.Path} or one of its scenes was changed meanwhile: the marks are by what was read at the start");
        foreach (var page in folder.ChangedPages())
            options.Notice?.Invoke($"{page} was changed after it was written, perhaps by a student's program: --resume writes it again");
        var others = decisions.Where(decision => !all.Any(submission => submission.Student == decision.Key));
        MarksFolder.Write(folder.PathOf(MarksFolder.Table), Encoding.UTF8.GetBytes(MarksTable.Of(rubric, marks, others)));
        MarksFolder.Write(folder.PathOf(MarksFolder.Moodle), Encoding.UTF8.GetBytes(MarksTable.ForMoodle(rubric, marks)));
        MarksFolder.Write(folder.PathOf(MarksFolder.Canvas), Encoding.UTF8.GetBytes(MarksTable.ForCanvas(rubric, marks)));
        MarksFolder.Write(folder.PathOf(MarksFolder.ClassPage), Encoding.UTF8.GetBytes(ClassPage.Of(rubric, marks)));
        return marks;
    }

    /// <summary>Marks and submissions must not write to the same place, which would show only after all programs have run.</summary>
    private static void RefuseSharedPlaces(IReadOnlyList<Submission> all, string submissions, string output)
    {
        var above = Path.GetFullPath(submissions).TrimEnd(Path.DirectorySeparatorChar) + Path.DirectorySeparatorChar;
        if ((Path.GetFullPath(output) + Path.DirectorySeparatorChar).StartsWith(above, StringComparison.OrdinalIgnoreCase))
            throw new ProblemException($"the marks cannot go to {output}, which is in the folder of submissions: name a folder outside it");
        if (File.Exists(output)) throw new ProblemException($"the marks cannot go to {output}, which is a file: name a folder");
        foreach (var submission in all)
            if (MarksFolder.Files.Contains(submission.Student.ToLowerInvariant()))
                throw new ProblemException($"the submission '{submission.Student}' is named like a file of the marks: rename the folder");
        foreach (var file in MarksFolder.Files)
            if (Directory.Exists(Path.Combine(output, file)))
                throw new ProblemException($"cannot write {Path.Combine(output, file)}, which is a folder: rename it");
    }

    private void MarkAll(IReadOnlyList<Submission> all, Options options, CancellationToken cancellation, out StudentMarks[] marks)
    {
        try
        {
            Parallel.ForEach(Partitioner.Create(all, EnumerablePartitionerOptions.NoBuffering),
                new() { MaxDegreeOfParallelism = options.Threads, CancellationToken = cancellation }, submission =>
                {
                    options.Progress?.Invoke(done.Count, all.Count, submission.Student);
                    done[submission.Student] = MarkOne(submission, options, cancellation);
                });
        }
        catch (AggregateException several)
        {
            ExceptionDispatchInfo.Throw(several.InnerExceptions[0]);
        }
        foreach (var submission in options.Threads > 1 ? all.Where(IsVictim) : [])
            done[submission.Student] = MarkOne(submission, options with { Resume = false }, cancellation);
        var same = SourceTokens.Repeated(all);
        marks = [.. all.Select(submission => done[submission.Student]).Select(student => same.TryGetValue(student.Student, out var others)
            ? student with { LookYourself = [.. student.LookYourself, $"the same source as {others}, up to names and layout"] } : student)];
    }

    /// <summary>Whether a picture is missing of a submission that ran beside a program which took all processes: it is run again, alone.</summary>
    private bool IsVictim(Submission submission) =>
        times.TryGetValue(submission.Student, out var time) && programs.HasMultiplied(time.Start, time.End)
            && done[submission.Student].Scenes.Any(scene => scene.Verdict == SceneVerdict.NoPicture);

    /// <summary>Marks a submission. Whatever goes wrong with it, the others are marked, too.</summary>
    private StudentMarks MarkOne(Submission submission, Options options, CancellationToken cancellation)
    {
        try
        {
            if (options.Resume && folder.Read(submission.Student, DigestOf(submission)) is { } kept) return kept;
            var start = Stopwatch.GetTimestamp();
            string[] notes = digestsAtStart.TryGetValue(submission.Student, out var digest) && digest != submission.Digest()
                ? ["its files were changed after the run began and before it was its turn, perhaps by another program"] : [];
            var pictures = runner.Pictures(submission, cancellation);
            string? problem = null;
            var steps = pictures.All(picture => picture.Picture is null) ? null : tests?.Of(submission, cancellation, out problem);
            times[submission.Student] = (start, Stopwatch.GetTimestamp());
            cancellation.ThrowIfCancellationRequested();
            if (problem is not null) notes = [.. notes, problem];
            var marks = Decided(marker.Mark(submission.Student, pictures, steps, [.. notes, .. LibraryCalls.In(submission.Folder)]));
            return folder.Write(marks, FeedbackPage.Of(rubric, marks, pictures), DigestOf(submission));
        }
        catch (Exception e) when (e is not OperationCanceledException)
        {
            options.Notice?.Invoke($"{submission.Student}: {e.Message}");
            return Decided(marker.Mark(submission.Student, runner.None($"not marked: {e.Message}")));
        }
    }

    /// <summary>The marks with what the teacher has entered.</summary>
    private StudentMarks Decided(StudentMarks marks) => decisions.GetValueOrDefault(marks.Student) is { } decision
        ? marks with { TeacherPoints = decision.Points, Comment = decision.Comment } : marks;

    /// <summary>A hash of the rubric and the submission, with what building has made in it.</summary>
    private string? DigestOf(Submission submission) =>
        submission.Digest() is { } digest ? $"{rubric.Digest}{digest}{decisions.GetValueOrDefault(submission.Student)}" : null;
}
