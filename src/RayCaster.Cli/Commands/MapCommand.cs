namespace RayCaster.Cli;

internal sealed class MapCommand() : Command("map", "<scene> <kind>", "Writes numbers for each pixel: t, depth or model.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the numbers: .pfm; their picture gets the same name with .png. [default: <scene>.<kind>.pfm]");

    public override string Description => "Writes a number for each pixel of a scene, and a picture of the numbers (docs/maps.md).";

    public override IReadOnlyList<(string, string)> Arguments =>
        [Scene, ("<kind>", "t of the nearest hit, its depth along the view, or the index of its model: t, depth or model.")];

    public override IReadOnlyList<Option> Options => [output, Option.Size, Option.Threads, Option.Quiet];

    public override string[] Examples => ["map scenes/room.json depth"];

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var operands = line.Exactly("<scene>", "<kind>");
        if (MapKinds.Named(operands[1]) is not { } kind)
            throw ProblemException.Usage($"'{operands[1]}' is not a map: choose t, depth or model");
        var numbers = line.Get(output) ?? $"{SceneInput.NameOf(operands[0])}.{kind.Name()}.pfm";
        if (!numbers.EndsWith(".pfm", StringComparison.OrdinalIgnoreCase))
            throw ProblemException.Usage(
                $"a map's numbers go to a file that ends in .pfm, but '{numbers}' is given; its picture gets the same name with .png");
        // A name of its own, so "-o room.pfm" does not replace the picture room.png.
        var ending = $".{kind.Name()}";
        var picture = numbers[..^4] + (numbers[..^4].EndsWith(ending, StringComparison.Ordinal) ? "" : ending) + ".png";
        var scene = SceneInput.Read(operands[0], line, cancellation);

        var map = MapMaker.Make(scene, kind, line.Get(Option.Threads));
        OutputFile.Write(numbers, cancellation, file => PfmFile.Write(file, map));
        PictureOutput.Write(picture, MapPicture.Draw(map, kind), PictureFormat.Png, cancellation);
        var range = kind != MapKind.Model && map.Range is var (least, greatest) ? $", {kind.Name()} from {least:G7} to {greatest:G7}" : "";
        line.Tell($"{numbers}, {picture}: {map.Width} x {map.Height} pixels{range}");
        return ExitCode.Done;
    }
}
