namespace RayCaster.Cli;

internal sealed class StitchCommand : Command
{
    private const int MaxReasons = 20;

    public override string Help => """
        Description:
          Joins the parts of a picture that "raycaster <scene> --rows ..." has drawn, here or on
          many machines. The picture has the same pixels as one that is drawn at once.

        Usage:
          raycaster stitch <part>... -o <file> [options]
          raycaster stitch <part>... --missing

        Arguments:
          <part>...  Files, patterns like "parts/room.part-*.png", or folders: all PNG files in
                     them that are parts. The order does not matter.

        Options:
          -o, --output <file>    Where to write the picture: .png or .ppm; "-" writes it to a
                                 redirected standard output, as PPM.
              --format <format>  png, ppm or ppm-text (PPM in readable numbers).
                                 [default: by the file's extension]
              --missing          Writes no picture. Prints the lines that no part holds, in the
                                 form of --rows; nothing if no line is missing.
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.

        stitch refuses parts of different scenes, sizes or program versions, missing lines, and
        lines that two parts hold (even if they are equal: remove one of the files). The message
        names the files and lines, and an existing picture stays as it is.

        Examples, where raycaster is "dotnet run --project src/RayCaster.Cli --":
          raycaster stitch room.part-*.png -o room.png
          for lines in $(raycaster stitch parts --missing); do
            raycaster scenes/room.json --rows $lines -o parts/$lines.png
          done

        Exit codes:
          0 done, or with --missing: no line is missing, 1 lines are missing or parts do not
          belong together, 2 failed, for example because a part is damaged.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        if (line.Operands.Count == 0) throw ProblemException.Usage("no part is given: name files, a pattern or a folder");
        var onlyMissing = line.Has(Option.Missing);
        if (line[Option.Output] is not null == onlyMissing)
            throw ProblemException.Usage(onlyMissing
                ? "--missing writes no picture: leave -o out"
                : "stitch needs a name for the picture, as in -o room.png, or --missing to list the missing lines");
        var output = line[Option.Output] ?? "";
        var format = onlyMissing ? PictureFormat.Png : PictureOutput.FormatOf(line, output);

        var files = InputFiles.Of(line.Operands, out var chosen);
        var start = Stopwatch.GetTimestamp();
        var parts = new PartSet(files, chosen.Contains);
        if (parts.Count == 0 && parts.Problems.Count == 0)
            throw new ProblemException($"there are no parts of a picture in {string.Join(", ", line.Operands)}");

        if (parts.Problems.Count > 0) return No("these are not the parts of one picture", parts.Problems);
        if (onlyMissing)
        {
            StandardStreams.WriteOutput(string.Concat(parts.Missing.Select(lines => $"{lines}\n")));
            return parts.Missing.Count == 0 ? ExitCode.Done : ExitCode.No;
        }
        if (parts.Missing.Count > 0)
            return No($"of {parts.Size.Height} lines these are missing", [.. parts.Missing.Select(lines => lines.ToString())]);

        InputFiles.Note(parts.Files);
        var (width, height) = parts.Size;
        PictureOutput.Write(output, cancellation, stream =>
        {
            using var progress = ProgressLine.For(line, width, height, "pixels");
            using var writer = PictureWriter.Create(format, stream, width, height);
            parts.Write(writer, lines => progress?.LinesDone(lines), cancellation);
            writer.Finish();
        });
        var seconds = Stopwatch.GetElapsedTime(start).TotalSeconds;
        line.Tell($"{PictureOutput.NameOf(output)}: {width} x {height} pixels, {Digits.Count(parts.Count, "part")}, {seconds:0.00} s");
        return ExitCode.Done;
    }

    private static int No(string answer, IReadOnlyList<string> reasons)
    {
        var shown = string.Concat(reasons.Take(MaxReasons).Select(reason => $"  {reason}\n"));
        var more = reasons.Count > MaxReasons ? $"  and {reasons.Count - MaxReasons} more\n" : "";
        StandardStreams.WriteError($"raycaster: {answer}:\n{shown}{more}");
        return ExitCode.No;
    }
}
