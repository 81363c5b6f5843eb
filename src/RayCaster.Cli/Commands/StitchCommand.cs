namespace RayCaster.Cli;

internal sealed class StitchCommand() : Command("stitch", "<part>...", "Joins parts into one picture, or lists missing lines.")
{
    private const int MaxReasons = 20;

    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the picture: .png or .ppm; \"-\" writes it to a redirected standard output, as PPM.");
    private static readonly Option<bool> missing = Option.Switch("--missing",
        "Writes no picture. Prints the lines that no part holds, as \"part\" takes them; nothing if no line is missing.");

    public override string Description =>
        "Joins the parts of a picture that \"part\" has drawn, here or on many machines. The picture has the same pixels as one that " +
        "is drawn at once. Refuses parts of different scenes, sizes or program versions, missing lines, and lines that two parts hold (even if " +
        "they are equal: remove one of the files).";

    public override IReadOnlyList<(string, string)> Arguments =>
    [
        ("<part>...", "Files, patterns like \"parts/room.part-*.png\", or folders: all PNG files in them that are parts. " +
            "The order does not matter."),
    ];

    public override Option[] Options => [output, Option.Format, missing, Option.Quiet];

    public override string[] Examples => ["stitch room.part-*.png -o room.png"];

    public override string ExitCodes =>
        "0 done, or with --missing: no line is missing, 1 lines are missing or parts do not belong together, " +
        "2 failed, for example because a part is damaged.";

    public override int Run(CommandLine line)
    {
        if (line.Operands.Count == 0) throw ProblemException.Usage("no part is given: name files, a pattern or a folder");
        var file = line.Get(output) ?? "";
        var onlyMissing = line.Get(missing);
        if (onlyMissing && file != "") throw ProblemException.Usage("--missing writes no picture: leave -o out");
        if (!onlyMissing && file == "")
            throw ProblemException.Usage("stitch needs a name for the picture, as in -o room.png, or --missing to list the missing lines");
        var format = onlyMissing ? PictureFormat.Png : PictureOutput.FormatOf(file, line.Get(Option.Format));

        var start = Stopwatch.GetTimestamp();
        var named = Glob.Expand([.. line.Operands.Where(operand => !Directory.Exists(operand))]);
        var inFolders = line.Operands.Where(Directory.Exists).SelectMany(folder => Glob.FilesIn(folder, "*.png"));
        string[] files = [.. named.Concat(inFolders).DistinctBy(Path.GetFullPath)];
        var parts = new PartSet(files, named.Contains, whole: onlyMissing);
        if (parts.Count + parts.Problems.Count + parts.Unreadable.Count == 0)
            throw new ProblemException($"there are no parts of a picture in {string.Join(", ", line.Operands)}");

        if (parts.Problems.Count > 0) No("these are not the parts of one picture", parts.Problems);
        else if (onlyMissing) StandardStreams.WriteOutput(string.Concat(parts.Missing.Select(lines => $"{lines}\n")));
        if (parts.Unreadable.Count > 0) return Unreadable(parts);
        if (parts.Problems.Count > 0) return ExitCode.No;
        if (onlyMissing) return parts.Missing.Count == 0 ? ExitCode.Done : ExitCode.No;
        if (parts.Missing.Count > 0)
            return No($"of {parts.Size.Height} lines these are missing", [.. parts.Missing.Select(lines => lines.ToString())]);

        OutputFile.Protect(parts.Files);
        var (width, height) = parts.Size;
        using (var progress = ProgressLine.For(line))
        using (var picture = new PictureOutput(file, format, width, height))
        {
            var isWritten = true;
            try
            {
                parts.Read(row =>
                {
                    isWritten = false;
                    picture.WriteRows(row);
                    isWritten = true;
                    progress?.LinesDone(1, height);
                });
            }
            catch (ProblemException) when (isWritten && new PartSet(files, named.Contains, whole: true) is { Unreadable.Count: > 0 } damaged)
            {
                return Unreadable(damaged); // all of them, not only the first
            }
            picture.Finish();
        }
        var seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        line.Tell($"{OutputFile.NameOf(file)}: {width} x {height} pixels, {Digits.Count(parts.Count, "part")}, {seconds:0.00} s");
        return ExitCode.Done;
    }

    private static int No(string answer, IReadOnlyList<string> reasons)
    {
        StandardStreams.WriteError($"raycaster: {answer}:\n" + Listed("  ", reasons));
        return ExitCode.No;
    }

    private static int Unreadable(PartSet parts)
    {
        StandardStreams.WriteError(Listed("raycaster: ", parts.Unreadable));
        return ExitCode.Failed;
    }

    private static string Listed(string before, IReadOnlyList<string> reasons) =>
        string.Concat(reasons.Take(MaxReasons).Select(reason => $"{before}{reason}\n"))
        + (reasons.Count > MaxReasons ? $"  and {reasons.Count - MaxReasons} more\n" : "");
}
