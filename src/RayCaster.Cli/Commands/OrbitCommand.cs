namespace RayCaster.Cli;

internal sealed class OrbitCommand() : Command("orbit", "<scene>", "Draws the frames of a camera that goes around its target.")
{
    private static readonly Option<int?> frames = Option.Count("--frames",
        "How many frames. Frame 0 is the scene's own picture, and the camera turns counterclockwise, seen from above (from where \"up\" points to).",
        1_000_000);
    private static readonly Option<string> only = new("--only", "<frames>",
        "Draws only these frames, for example 0..11 (both included) or 3/8 (the third of eight parts), for many machines.",
        "the first and the last frame as in 0..11, counted from 0, or 3/8 for the third of eight parts",
        text => PartCommand.RangeOf(text) is null ? null : text);
    private static readonly Option<string> output = Option.Text("-o, --output", "<folder>",
        "An existing folder for the frames. [default: the current one]");

    public override string Description =>
        "Draws the frames of a camera that goes once around its target: room-0000.png, room-0001.png ...";

    public override Option[] Options =>
        [frames, only, output, Option.Size, PartCommand.Resume, Option.Threads, Option.Quiet];

    public override string[] Examples => ["orbit scenes/room.json --frames 48 -o frames"];

    public override int Run(CommandLine line)
    {
        var path = line.Exactly("<scene>")[0];
        var count = line.Get(frames) ?? throw ProblemException.Usage("orbit needs a number of frames, as in --frames 48");
        var wanted = NumberRange.Whole(count);
        if (line.Get(only) is { } portion)
            wanted = PartCommand.RangeOf(portion, count) ?? throw new ProblemException($"there are no frames {portion} of {count}, 0..{count - 1}");
        var scene = SceneInput.Read(path, line);

        var folder = line.Get(output) ?? "";
        var models = SceneDigest.OfModels(scene.Models);
        var whole = NumberRange.Whole(scene.Camera.Height);
        var start = Stopwatch.GetTimestamp();
        var drawn = 0;
        for (var frame = wanted.First; frame <= wanted.Last; frame++)
        {
            var view = scene with { Camera = CameraMotion.Orbit(scene.Camera, frame, count) };
            if (view.Camera.ValidationError is { } flaw) throw new ProblemException($"frame {frame} cannot be drawn: {flaw}");
            var file = Path.Combine(folder, $"{SceneInput.NameOf(path)}-{PartCommand.Padded(frame, count)}.png");
            var part = PartFacts.Create(view, whole, models, typeof(Renderer).Assembly); // the file contains what it shows, so --resume can skip it
            // The reason to draw a frame again is printed for the first one only.
            if (line.Get(PartCommand.Resume) && PartCommand.IsUpToDate(file, part, line.Get(Option.Quiet) || drawn > 0)) continue;
            new Drawing(view, line, manyFrames: true).Write(file, PictureFormat.Png, part: part);
            drawn++;
        }
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        line.Tell($"{(folder == "" ? "." : folder)}: {Digits.Count(drawn, "frame")} of {width} x {height} pixels drawn, " +
            $"{wanted.Count - drawn} existed already, {Stopwatch.GetElapsedTime(start).TotalSeconds:0.00} s");
        return ExitCode.Done;
    }
}
