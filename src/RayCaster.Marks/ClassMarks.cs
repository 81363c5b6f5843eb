namespace RayCaster.Marks;

/// <summary>Marks the submissions of a class, and writes a table, a page for each student, and a page for the teacher.</summary>
/// <param name="output">The folder for the results; made if it does not exist.</param>
/// <param name="threads">How many students are marked at the same time.</param>
/// <param name="progress">Called with the number of finished students, the number of all, and who is marked next.</param>
/// <param name="notice">Called with what the teacher must know besides the marks.</param>
public sealed class ClassMarks(Rubric rubric, string output, int threads, Action<int, int, string>? progress = null, Action<string>? notice = null)
{
    private const string Table = "marks.csv", ClassFile = "class.html", StudentFile = "feedback.html";

    private readonly Marker marker = new(rubric);
    private int done, withoutTests;

    /// <summary>Marks all submissions in a folder.</summary>
    /// <param name="folder">Contains a folder for each student.</param>
    /// <returns>How many there are, and how many of them the teacher must look at.</returns>
    /// <exception cref="ProblemException">The folder or the teacher's table cannot be read, or a file not be written.</exception>
    public (int Count, int ToLookAt) Mark(string folder)
    {
        var submissions = Submission.In(folder, rubric);
        RefuseInside(folder);
        var decisions = TeacherTable.Read(Path.Combine(output, Table), [.. submissions.Select(submission => submission.Student)]);
        ReportFilesAndDecisions(folder, decisions.Keys);

        Directory.CreateDirectory(output); // or fails before the work
        var marks = new StudentMarks[submissions.Count];
        Parallel.For(0, marks.Length, new() { MaxDegreeOfParallelism = threads }, i =>
        {
            progress?.Invoke(done, marks.Length, submissions[i].Student);
            marks[i] = MarkOne(submissions[i], decisions.GetValueOrDefault(submissions[i].Student));
            Interlocked.Increment(ref done);
        });
        if (rubric.Tests is not null && withoutTests > 0)
            notice?.Invoke($"{withoutTests} of {marks.Length} submissions have no test results {rubric.Tests}: only their pictures count" +
                (rubric.Items.Any(item => item.Evidence == ItemEvidence.Tests) ? ", and what tests alone decide is undecided" : ""));

        Write(Table, MarksTable.Format(rubric, marks));
        Write(ClassFile, ClassPage.Create(rubric, marks));
        return (marks.Length, marks.Count(student => student.LookYourself.Count > 0));
    }

    /// <summary>Marks must not be taken for a submission in the next run.</summary>
    private void RefuseInside(string folder)
    {
        var above = Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder)) + Path.DirectorySeparatorChar;
        if ((Path.GetFullPath(output) + Path.DirectorySeparatorChar).StartsWith(above, StringComparison.OrdinalIgnoreCase))
            throw new ProblemException($"the marks cannot go to {output}, which is in the folder of submissions: name a folder outside it");
    }

    private void ReportFilesAndDecisions(string folder, IReadOnlyCollection<string> decided)
    {
        if (Submission.LooseFiles(folder) is [var loose, .. var more])
            notice?.Invoke($"a submission is a folder, so {PrintableText.From(Path.Combine(folder, loose))}" +
                (more.Length == 0 ? " is not marked" : $" and {more.Length} more are not marked"));
        if (decided.Count > 0)
            notice?.Invoke($"{Path.Combine(output, Table)}: using your points or comments for {string.Join(", ", decided)}");
    }

    /// <summary>Marks a submission and writes its page. Whatever goes wrong with it, the others are marked, too.</summary>
    private StudentMarks MarkOne(Submission submission, TeacherDecision? decision)
    {
        try
        {
            var pictures = submission.Pictures(rubric);
            var tests = rubric.Tests is null ? null : TestResults.In(submission, rubric);
            if (tests?.HasFiles != true) Interlocked.Increment(ref withoutTests);
            var marks = Decided(marker.Mark(submission.Student, pictures, tests?.Steps, tests?.Notes ?? []));
            Write(Path.Combine(submission.Student, StudentFile), FeedbackPage.Create(rubric, marks, pictures));
            return marks;
        }
        catch (Exception e) when (e is not OperationCanceledException)
        {
            notice?.Invoke($"{submission.Student}: {e.Message}");
            return Decided(marker.Mark(submission.Student, Submission.None(rubric, $"not marked: {e.Message}")));
        }

        StudentMarks Decided(StudentMarks marks) => marks with { TeacherPoints = decision?.Points, Comment = decision?.Comment ?? "" };
    }

    private void Write(string file, string text)
    {
        var path = Path.Combine(output, file);
        Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(path))!);
        AtomicFile.Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(text)));
    }
}
