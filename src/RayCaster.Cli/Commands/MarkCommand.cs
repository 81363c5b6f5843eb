namespace RayCaster.Cli;

internal sealed class MarkCommand() : Command("mark", "<rubric> [<submissions>]", "Marks a class by its pictures, with a page for each.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<folder>",
        "The folder for the marks: marks.csv, moodle.csv, canvas.csv, class.html for the teacher, and feedback.html for each student.");
    private static readonly Option<string> ids = Option.Text("--ids", "<file>", "Names rows and pages by ids: a CSV file of folders and ids.");

    public override string Description =>
        "Marks the submissions of a class by their pictures: runs each program on the scenes of a rubric, or reads the pictures in its folder, " +
        "finds the mistakes, and gives points. Pictures that no known mistake explains are not scored; the teacher must look at them. " +
        "The students' programs run with your rights: docs/teaching.md says which limits they have, and what only a container prevents.";

    public override IReadOnlyList<(string, string)> Arguments =>
    [
        ("<rubric>", "Scenes, how to run a program, and what costs points (JSON, docs/teaching.md). Without <submissions>, the rubric is " +
            "checked: which of its mistakes no scene can show."),
        ("<submissions>", "A folder that contains a folder for each student, or a ZIP file of folders or ZIP files, which is unpacked beside it."),
    ];

    public override IReadOnlyList<Option> Options => [output, ids, PartCommand.Resume, Option.Threads, Option.Quiet, Option.NoProgress];

    public override string[] Examples => ["mark docs/rubric.json", "mark docs/rubric.json submissions -o marks"];

    public override string ExitCodes => "0 marked, whatever the marks are; 1 the rubric has errors; 2 failed.";

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        if (line.Operands.Count is 0 or > 2) throw ProblemException.Usage("mark takes <rubric> and <submissions>");
        var rubric = RubricReader.Read(line.Operands[0], out var report);
        StandardStreams.WriteError(report);
        if (rubric is null) return File.Exists(line.Operands[0]) ? ExitCode.No : ExitCode.CouldNot;
        if (line.Operands.Count == 1)
        {
            StandardStreams.WriteOutput(RubricReport.Text(rubric));
            return ExitCode.Done;
        }

        if (line.Get(output) is not { } folder) throw ProblemException.Usage("mark needs a folder for the marks, as in -o marks");
        var runs = rubric.Source.Run.Count > 0;
        if (runs) line.Tell(RubricReport.LimitsOf(rubric));
        using var progress = ProgressLine.For(line, 0, 0, "submissions");
        var start = Stopwatch.GetTimestamp();
        var options = new ClassMarks.Options(
            line.Get(Option.Threads) ?? (runs ? 2 : 1) * Environment.ProcessorCount, line.Get(PartCommand.Resume),
            (done, all, next) => progress?.Show(done, all, next), StandardStreams.WriteError)
        {
            Ids = line.Get(ids),
        };
        var marks = ClassMarks.Mark(rubric, line.Operands[1], folder, options, cancellation);
        progress?.Dispose();
        var (flagged, seconds) = (marks.Count(student => student.LookYourself.Count > 0), Stopwatch.GetElapsedTime(start).TotalSeconds);
        line.Tell($"{folder}: {marks.Count} submission{(marks.Count == 1 ? "" : "s")} marked, {flagged} to look at yourself, {seconds:0.0} s");
        if (marks.Count > 1 && marks.Select(student => student.CommonProblem).Distinct().ToArray() is [not null]) // for one reason
            StandardStreams.WriteError($"No submission has a picture. Does {line.Operands[1]} contain a folder for each student?");
        return ExitCode.Done;
    }
}
