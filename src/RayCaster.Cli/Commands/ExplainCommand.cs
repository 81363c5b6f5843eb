namespace RayCaster.Cli;

internal sealed class ExplainCommand() : Command("explain", "<scene> <column> <line>", "Shows how one pixel of the right picture gets its colour.")
{
    private static readonly Option<string> mine = Option.Text("--mine", "<file>",
        "The picture that your program drew of the scene: adds its colour at this pixel and, if that is wrong, which model would give it.");

    public override string Description =>
        "Shows how one pixel of the right picture gets its colour: the ray, each model's formula with this pixel's numbers, which crossings count " +
        "and why the others do not, and the colour. The numbers are the right ones: compare them with those of your program.";

    public override IReadOnlyList<(string, string)> Arguments =>
    [
        Scene,
        ("<column>", "The pixel's column, from the left, from 0."),
        ("<line>", "The pixel's line, from the top, from 0, as picture viewers count. " +
            "The formulas count rows from the bottom: r = height - 1 - line."),
    ];

    public override Option[] Options => [mine, Option.Size, Option.Quiet];

    public override string[] Examples => ["explain scenes/room.json 325 359", "explain scenes/room.json 325 359 --mine mine.png"];

    public override string ExitCodes => "0 done, 1 your picture differs there by more than rounding, 2 failed.";

    public override int Run(CommandLine line)
    {
        var operands = line.Exactly("<scene>", "<column>", "<line>");
        var scene = SceneInput.Read(operands[0], line);

        var camera = scene.Camera;
        var explanation = new PixelExplanation(scene,
            Coordinate("column", operands[1], camera.Width, "left to right"), Coordinate("line", operands[2], camera.Height, "top to bottom"));
        var other = line.Get(mine) is { } path ? ReferenceExplanation.Create(explanation, ReadMine(path, camera)) : null;
        StandardStreams.WriteOutput(ExplanationText.Format(explanation, other));
        return other is { Agrees: false } ? ExitCode.No : ExitCode.Done;
    }

    private static int Coordinate(string what, string text, int count, string order)
    {
        if (!long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var value))
            throw ProblemException.Usage($"'{text}' is not a {what}: it is a whole number from 0 to {count - 1}");
        return value >= 0 && value < count ? (int)value : throw new ProblemException(
            $"there is no {what} {value}: the picture has {what}s 0 to {count - 1}, {order}");
    }

    private static Picture ReadMine(string path, Camera camera)
    {
        var picture = PictureFile.Read(path, StandardStreams.WriteError);
        return (picture.Width, picture.Height) == (camera.Width, camera.Height) ? picture : throw new ProblemException(
            $"{path} has {picture.Width} x {picture.Height} pixels, but the scene's picture {camera.Width} x {camera.Height}\n" +
            $"  Its size as an option: --size {picture.Width}x{picture.Height}");
    }
}
