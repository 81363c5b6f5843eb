namespace RayCaster.Cli;

internal sealed class MarkCommand : Command
{
    public override string Help => """
        Description:
          Marks the submissions of a class by their pictures: runs each program on the scenes of a
          rubric, or reads the pictures in its folder, finds the mistakes, and gives points. Pictures
          that no known mistake explains are not scored; the teacher must look at them.

        Usage:
          raycaster mark <rubric> <submissions> -o <folder> [options]
          raycaster mark <rubric>

        Arguments:
          <rubric>       Scenes, how to run a program, and what costs points (JSON,
                         docs/teaching.md). Without <submissions>, the rubric is checked: which
                         of its mistakes no scene can show.
          <submissions>  A folder that contains a folder for each student, or a ZIP file of folders
                         or ZIP files, which is unpacked beside it.

        Options:
          -o, --output <folder>  The folder for the marks: marks.csv, moodle.csv, canvas.csv,
                                 class.html for the teacher, and feedback.html for each student.
              --ids <file>       Names rows and pages by ids: a CSV file of folders and ids.
              --resume           Keeps finished marks of submissions that have not changed.
          -t, --threads <n>      How many submissions are marked at a time. [default: one per core;
                                 two where programs run, since some wait for ever]
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.

        The students' programs run with your rights. docs/teaching.md says which limits they have,
        and what only a container prevents.

        Examples, where raycaster is "dotnet run --project src/RayCaster.Cli --":
          raycaster mark docs/rubric.json
          raycaster mark docs/rubric.json submissions -o marks

        Exit codes:
          0 marked, whatever the marks are; 1 the rubric has errors; 2 failed.
        """;

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

        if (line[Option.Output] is not { } output) throw ProblemException.Usage("mark needs a folder for the marks, as in -o marks");
        var runs = rubric.Source.Run.Count > 0;
        if (runs) line.Tell(RubricReport.LimitsOf(rubric));
        using var progress = ProgressLine.For(line, 0, 0, "submissions");
        var start = Stopwatch.GetTimestamp();
        var options = new ClassMarks.Options(
            line.ThreadCount() ?? (runs ? 2 : 1) * Environment.ProcessorCount, line.Has(Option.Resume),
            (done, all, next) => progress?.Show(done, all, next), StandardStreams.WriteError)
        {
            Ids = line[Option.Ids],
        };
        var marks = ClassMarks.Mark(rubric, line.Operands[1], output, options, cancellation);
        progress?.Dispose();
        var (flagged, seconds) = (marks.Count(student => student.LookYourself.Count > 0), Stopwatch.GetElapsedTime(start).TotalSeconds);
        line.Tell($"{output}: {marks.Count} submission{(marks.Count == 1 ? "" : "s")} marked, {flagged} to look at yourself, {seconds:0.0} s");
        if (marks.Count > 1 && marks.Select(student => student.CommonProblem).Distinct().ToArray() is [not null]) // for one reason
            StandardStreams.WriteError($"No submission has a picture. Does {line.Operands[1]} contain a folder for each student?");
        return ExitCode.Done;
    }
}
