namespace RayCaster.Cli;

internal sealed class CompareCommand : Command
{
    public override string Help => """
        Description:
          Says whether two pictures are the same, and where they differ. If a change of the
          whole picture explains the difference, names it: flipped, moved, red and blue
          swapped, ...

        Usage:
          raycaster compare <mine> <reference> [options]

        Arguments:
          <mine>       The picture in question: PNG, PPM, PGM or PBM.
          <reference>  The picture that it should be.

        Options:
              --scene <file>     The scene of the reference: the answer says which models are
                                 wrong, and rays decide which pixels are on outlines.
          -o, --output <file>    Writes mine, the reference and a heat map of the difference
                                 beside each other, .png or .ppm. Without it nothing is written.
              --measures         Adds maximum, MAE and RMSE.
          -t, --threads <n>      How many threads cast rays. [default: one per core]

        Two pictures are the same if they are identical, or if at most 1 % of the pixels
        differ by 1 of 255 levels. Also, a pixel on an outline may show the other side of the
        outline. Colours are compared as they are stored: transparency and colour profiles
        are ignored.

        Examples, where raycaster is "dotnet run --project src/RayCaster.Cli --":
          raycaster compare mine.png right.png
          raycaster compare mine.ppm right.png --scene scenes/room.json -o difference.png

        Exit codes:
          0 same, 1 different, 2 failed.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var files = line.Exactly("<mine>", "<reference>");
        var (mineFile, referenceFile, output, threads) = (files[0], files[1], line[Option.Output], line.ThreadCount());
        InputFiles.Note(files);
        var format = output is null ? PictureFormat.Png : PictureFormats.ByExtension(output);
        var (mine, reference) = (PictureFile.Read(mineFile, StandardStreams.WriteError), PictureFile.Read(referenceFile, StandardStreams.WriteError));
        var scene = line[Option.Scene] is { } path ? SceneInput.Read(path, line, cancellation, warns: false, judges: true) : null;
        if (scene is null && line.Has(Option.Scene)) return ExitCode.CouldNot;

        var comparison = new PictureComparison(mine, reference, scene, threads);
        if (output is not null) PictureOutput.Write(output, SideBySide.Draw(comparison), format, cancellation);
        StandardStreams.WriteOutput(Text(comparison, mineFile, referenceFile, output, line.Has(Option.Measures)));
        return comparison.Likeness.IsSame() ? ExitCode.Done : ExitCode.No;
    }

    private static string Text(PictureComparison comparison, string mine, string reference, string? output, bool measures)
    {
        var text = ComparisonText.Of(comparison, mine, reference);
        if (measures)
            text += comparison.Difference is { } difference
                ? ComparisonText.Measures(difference)
                : "There are no measures for pictures of different sizes.\n";
        var heat = comparison.Difference is null ? "" : ", the difference as a heat map";
        if (output is not null) return text + $"{output}: mine, the reference{heat}\n";
        return comparison.Likeness.IsSame() || comparison.Difference is null ? text : text + "To see the differences: -o difference.png\n";
    }
}
