using System.Runtime.CompilerServices;
using RayCaster.Marks;

namespace RayCaster.Cli;

internal sealed class MarkCommand() : Command("mark", "<rubric> [<pictures>]", "Marks a class by its pictures, with a page for each.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<folder>",
        "The folder for the marks: marks.csv, class.html for the teacher, and feedback.html for each student. Points and comments that you have " +
        "entered into its marks.csv are kept.");
    private static readonly Option<int?> threads = Option.Count("-t, --threads",
        "How many students are marked at a time. [default: one per core]", 1024);

    public override string Description =>
        "Marks a class by pictures and test results: finds the mistakes, and gives points. What no known mistake explains is not scored; the " +
        "teacher must look at it. It runs no program: docs/teaching.md says how the students' programs draw the pictures.";

    public override IReadOnlyList<(string, string)> Arguments =>
    [
        ("<rubric>", "Scenes, where the pictures are, and what costs points (JSON, docs/teaching.md). Without <pictures>, the rubric is checked: " +
            "which of its mistakes no scene can show."),
        ("<pictures>", "A folder that contains a folder of pictures for each student."),
    ];

    public override Option[] Options => [output, threads, Option.Quiet];

    public override string[] Examples => ["mark docs/rubric.json", "mark docs/rubric.json pictures -o marks"];

    public override string ExitCodes => "0 marked, whatever the marks are; 1 the rubric has errors; 2 failed.";

    public override int Run(CommandLine line)
    {
        try
        {
            return Mark(line);
        }
        catch (FileNotFoundException e) when (e.FileName?.StartsWith("RayCaster.Marks,", StringComparison.Ordinal) == true)
        {
            throw new ProblemException("RayCaster.Marks.dll is not beside this program, which may be a hand-out's own: that one does not mark\n" +
                "  Mark with a clone of the project, or with the installed tool.");
        }
    }

    /// <summary>A method of its own, because the runtime looks for RayCaster.Marks when it compiles one that uses it.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private static int Mark(CommandLine line)
    {
        if (line.Operands.Count is 0 or > 2) throw ProblemException.Usage("mark takes <rubric> and <pictures>");
        var rubric = RubricReader.Read(line.Operands[0], out var report);
        StandardStreams.WriteError(report);
        if (rubric is null) return File.Exists(line.Operands[0]) ? ExitCode.No : ExitCode.Failed;
        if (line.Operands.Count == 1)
        {
            StandardStreams.WriteOutput(RubricReport.Text(rubric));
            return ExitCode.Done;
        }

        if (line.Get(output) is not { } folder) throw ProblemException.Usage("mark needs a folder for the marks, as in -o marks");
        using var progress = ProgressLine.For(line, "submissions");
        var start = Stopwatch.GetTimestamp();
        var marks = new ClassMarks(rubric, folder, line.Get(threads) ?? Environment.ProcessorCount,
            (done, all, next) => progress?.Show(done, all, next), StandardStreams.WriteError);
        var (count, toLookAt) = marks.Mark(line.Operands[1]);
        progress?.Dispose();
        line.Tell($"{folder}: {Digits.Count(count, "submission")} marked, {toLookAt} to look at yourself, " +
            $"{Stopwatch.GetElapsedTime(start).TotalSeconds:0.0} s");
        return ExitCode.Done;
    }
}
