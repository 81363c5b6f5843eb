namespace RayCaster.Cli;

internal sealed class DrawCommand() : Command("draw", "<scene>", "Draws a scene.")
{
    private static readonly Option<string> output = Option.Text("-o, --output", "<file>",
        "Where to write the picture: .png or .ppm; \"-\" writes it to a redirected standard output, as PPM. " +
        "[default: the scene's name with .png, in the current folder]");
    private static readonly Option<bool> plain = Option.Switch("--plain",
        "Draws by the definition, ScalarRenderer, ray by ray: for the debugger and for Console.WriteLine in a formula.");

    public override string Description => "Draws a scene: casts one ray for each pixel and writes the picture.";

    public override Option[] Options =>
        [output, Option.Format, Option.Size, Option.Threads, plain, Option.Quiet, Option.Version];

    public override string[] Examples => ["scenes/room.json", "scenes/room.json -o room.ppm --size 1920x1080"];

    public override string ExitCodes =>
        "0 done, 1 the answer is no (pictures differ, parts are missing), 2 failed, 70 internal error, 129 hung up, 130 interrupted, " +
        "143 terminated.";

    public override int Run(CommandLine line)
    {
        var path = OneScene(line.Operands);
        var file = line.Get(output) ?? SceneInput.NameOf(path) + ".png";
        var format = PictureOutput.FormatOf(file, line.Get(Option.Format));
        var scene = SceneInput.Read(path, line);

        var start = Stopwatch.GetTimestamp();
        var drawing = new Drawing(scene, line, line.Get(plain));
        var isBlank = drawing.Write(file, format);
        line.Tell(drawing.Summary(file, scene.Camera.Height, Stopwatch.GetElapsedTime(start)));
        if (isBlank && !line.Get(Option.Quiet)) StandardStreams.WriteError(ModelsCommand.WhyNothingShows(scene));
        return ExitCode.Done;
    }

    private static string OneScene(IReadOnlyList<string> operands) => operands switch
    {
        [var scene] => scene,
        [] => throw ProblemException.Usage("no scene is given: name a scene file, for example scenes/room.json"),
        _ when File.Exists(string.Join(' ', operands)) =>
            throw ProblemException.Usage($"a file's name with blanks stands in quotes: \"{string.Join(' ', operands)}\""),
        [_, var second] when Path.GetExtension(second).ToLowerInvariant() is ".png" or ".ppm" =>
            throw ProblemException.Usage($"one scene at a time, but there are 2: {string.Join(", ", operands)}; did you mean -o {second}?"),
        _ => throw ProblemException.Usage($"one scene at a time, but there are {operands.Count}: {string.Join(", ", operands)}"),
    };
}
