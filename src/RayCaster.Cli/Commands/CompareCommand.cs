namespace RayCaster.Cli;

internal sealed class CompareCommand() : Command("compare", "<mine> <reference>", "Says whether two pictures are the same, and where not.")
{
    private static readonly Option<string> sceneFile = Option.Text("--scene", "<file>",
        "The scene of the reference: the answer says which models are wrong, and rays decide which pixels are on outlines.");
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Writes mine, the reference and a heat map of the difference beside each other, .png or .ppm. Without it nothing is written.");

    public override string Description =>
        "Says whether two pictures are the same, and where they differ. If a change of the whole picture explains the difference, names it: " +
        "flipped, moved, red and blue swapped, ... Two pictures are the same if they are identical, or if at most 1 % of the pixels differ by " +
        "1 of 255 levels. Also, a pixel on an outline may show the other side of the outline. Colours are compared as they are stored: " +
        "transparency and colour profiles are ignored. Two pictures can be compared without their scene, so this is an option here, " +
        "while diagnose and explain begin with it.";

    public override IReadOnlyList<(string, string)> Arguments =>
        [("<mine>", "The picture in question: PNG, PGM or PPM."), ("<reference>", "The picture that it should be.")];

    public override Option[] Options => [sceneFile, output, Option.Threads];

    public override string[] Examples => ["compare mine.png right.png", "compare mine.ppm right.png --scene scenes/room.json -o difference.png"];

    public override string ExitCodes => "0 same, 1 different, 2 failed.";

    public override int Run(CommandLine line)
    {
        var files = line.Exactly("<mine>", "<reference>");
        var mineFile = files[0];
        var referenceFile = files[1];
        var file = line.Get(output);
        OutputFile.Protect(files);
        var format = file is null ? PictureFormat.Png : PictureFile.FormatOf(file);
        Action<string> warn = StandardStreams.WriteError;
        var mine = PictureFile.Read(mineFile, warn);
        var reference = PictureFile.Read(referenceFile, warn);
        var scene = line.Get(sceneFile) is { } path ? SceneInput.Read(path, line, warns: false, judges: true) : null;
        var comparison = new PictureComparison(mine, reference, scene, line.Get(Option.Threads));
        if (file is not null) PictureOutput.Write(file, SideBySide.Draw(comparison), format);
        StandardStreams.WriteOutput(Text(comparison, mineFile, referenceFile, file));
        return comparison.Likeness.IsSame() ? ExitCode.Done : ExitCode.No;
    }

    private static string Text(PictureComparison comparison, string mine, string reference, string? output)
    {
        var text = ComparisonText.Format(comparison, mine, reference);
        var heat = comparison.Difference is null ? "" : ", the difference as a heat map";
        if (output is not null) return text + $"{output}: mine, the reference{heat}\n";
        return comparison.Likeness.IsSame() || comparison.Difference is null ? text : text + "To see the differences: -o difference.png\n";
    }
}
