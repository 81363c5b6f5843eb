namespace RayCaster.Cli;

internal sealed class MapCommand() : Command("map", "<scene> <kind>", "Draws t, depth or model in place of colours.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the picture: .png or .ppm. [default: <scene>.<kind>.png]");

    public override string Description => "Draws a picture of a number of each pixel's hit (docs/maps.md).";

    public override IReadOnlyList<(string, string)> Arguments =>
        [Scene, ("<kind>", "t of the nearest hit, its depth along the view, or the index of its model: t, depth or model.")];

    public override Option[] Options => [output, Option.Format, Option.Size, Option.Threads, Option.Quiet];

    public override string[] Examples => ["map scenes/room.json depth"];

    public override int Run(CommandLine line)
    {
        var operands = line.Exactly("<scene>", "<kind>");
        if (MapKinds.Named(operands[1]) is not { } kind)
            throw ProblemException.Usage($"'{operands[1]}' is not a map: choose t, depth or model");
        var file = line.Get(output) ?? $"{SceneInput.NameOf(operands[0])}.{kind.Name()}.png";
        var format = PictureOutput.FormatOf(file, line.Get(Option.Format));
        var scene = SceneInput.Read(operands[0], line);
        var map = MapPicture.Draw(scene, kind, line.Get(Option.Threads));
        PictureOutput.Write(file, map.Picture, format);
        var range = map.Range is var (least, greatest) ? $", {kind.Name()} from {least:G7} to {greatest:G7}" : "";
        line.Tell($"{OutputFile.NameOf(file)}: {map.Picture.Width} x {map.Picture.Height} pixels{range}");
        return ExitCode.Done;
    }
}
