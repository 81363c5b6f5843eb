namespace RayCaster.Cli;

/// <summary>Drawing with --map: numbers for each pixel, and a picture of them.</summary>
internal static class MapOutput
{
    public static int Run(CommandLine line, string path, CancellationToken cancellation)
    {
        if (MapKinds.Named(line[Option.Map]!) is not { } kind)
            throw ProblemException.Usage($"'{line[Option.Map]}' is not a map: " +
                $"choose {string.Join(", ", MapKinds.Names[..^1])} or {MapKinds.Names[^1]}");
        if (line.Has(Option.Format)) throw ProblemException.Usage("a map is a PFM and a PNG; --format is for the picture");
        var numbers = line[Option.Output] ?? DrawCommand.NameOf(path) + $".{kind.Name()}.pfm";
        if (!numbers.EndsWith(".pfm", StringComparison.OrdinalIgnoreCase))
            throw ProblemException.Usage(
                $"a map's numbers go to a file that ends in .pfm, but '{numbers}' is given; its picture gets the same name with .png");
        // A name of its own, so "-o room.pfm" does not replace the picture room.png.
        var ending = $".{kind.Name()}";
        var picture = numbers[..^4] + (numbers[..^4].EndsWith(ending, StringComparison.Ordinal) ? "" : ending) + ".png";

        if (SceneInput.Read(path, line, cancellation) is not { } scene) return ExitCode.CouldNot;
        var map = MapMaker.Make(scene, kind, line.ThreadCount());

        PictureOutput.Write(numbers, cancellation, file => PfmFile.Write(file, map));
        PictureOutput.Write(picture, MapPicture.Draw(map, kind), PictureFormat.Png, cancellation);
        line.Tell($"{numbers}, {picture}: {map.Width} x {map.Height} pixels{Range(map, kind)}");
        if (line.Has(Option.Ledger) && !line.Has(Option.Quiet)) StandardStreams.WriteError(HitLedger.Take(scene, cancellation).Report());
        return ExitCode.Done;
    }

    private static string Range(NumberMap map, MapKind kind) => kind is MapKind.T or MapKind.Depth && map.Range is var (least, greatest)
        ? $", {kind.Name()} from {least:G7} to {greatest:G7}"
        : "";
}
