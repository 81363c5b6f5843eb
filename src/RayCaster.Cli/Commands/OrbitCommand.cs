namespace RayCaster.Cli;

internal sealed class OrbitCommand : Command
{
    private const int MaxFrames = 1_000_000;

    public override string Help => """
        Description:
          Draws the frames of a camera that goes once around its target, or along a path from
          a file: room-0000.png, room-0001.png ...

        Usage:
          raycaster orbit <scene> --frames <n> [options]

        Options:
              --frames <n>       How many frames. Without --keys frame 0 is the scene's own
                                 picture, and the camera turns counterclockwise, seen from above
                                 (from where "up" points to).
              --keys <file>      The camera's path (JSON, docs/frames.md). The first frame is at
                                 the first key, the last frame at the last key.
              --only <frames>    Draws only these frames, for example 0..11 (both included) or 3/8
                                 (the third of eight parts), for many machines.
          -o, --output <folder>  An existing folder for the frames. [default: the current one]
          -s, --size <W>x<H>     Overrides the scene's picture size, in pixels.
              --resume           Skips frames that exist already, complete and of the same scene
                                 and camera.
          -t, --threads <n>      How many threads cast rays. [default: one per core]
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.

        Examples, where raycaster is "dotnet run --project src/RayCaster.Cli --":
          raycaster orbit scenes/room.json --frames 48 -o frames
          raycaster animate frames -o room.png --fps 24
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var path = line.Exactly("<scene>")[0];
        var (threads, quiet) = (line.ThreadCount(), line.Has(Option.Quiet));
        var frames = line.Count(Option.Frames, "frames", MaxFrames)
            ?? throw ProblemException.Usage("orbit needs a number of frames, as in --frames 48");
        var only = line.Lines(Option.Only, frames, "frames", "a film");

        if (SceneInput.Read(path, line, cancellation) is not { } scene) return ExitCode.CouldNot;
        scene = SpatialOrder.Of(scene);
        CameraPath? way = null;
        if (line[Option.Keys] is { } keys)
        {
            InputFiles.Note([keys]);
            way = CameraPathReader.Read(keys, scene.Camera, out var report);
            StandardStreams.WriteError(report);
            if (way is null) return ExitCode.CouldNot;
        }

        var folder = line[Option.Output] ?? "";
        var name = DrawCommand.NameOf(path);
        var (start, drawn) = (Stopwatch.GetTimestamp(), 0);
        var models = SceneDigest.OfModels(scene.Models);
        for (var frame = only.First; frame <= only.Last; frame++)
        {
            cancellation.ThrowIfCancellationRequested();
            var camera = way?.Frame(scene.Camera, frame, frames) ?? CameraMotion.Orbit(scene.Camera, frame, frames);
            if (camera.ValidationError is { } flaw) throw new ProblemException($"frame {frame} cannot be drawn: {flaw}");
            var view = scene with { Camera = camera };
            var whole = LineRange.Whole(camera.Height);
            var output = Path.Combine(folder, $"{name}-{DrawCommand.Padded(frame, frames)}.png");
            var part = PartFacts.Of(view, whole, models, typeof(Renderer).Assembly); // the file contains what it shows, so --resume can skip it
            // The reason to draw a frame again is printed for the first one only.
            if (line.Has(Option.Resume) && PictureOutput.IsUpToDate(output, part, quiet || drawn > 0)) continue;
            PictureOutput.Draw(
                output, PictureFormat.Png, new(view, threads, plain: false, manyFrames: true), whole, part, line, cancellation);
            drawn++;
        }
        var (pixels, seconds) = ($"{scene.Camera.Width} x {scene.Camera.Height} pixels", Stopwatch.GetElapsedTime(start).TotalSeconds);
        line.Tell($"{(folder == "" ? "." : folder)}: {Digits.Count(drawn, "frame")} of {pixels} drawn, " +
            $"{only.Count - drawn} existed already, {seconds:0.00} s");
        return ExitCode.Done;
    }
}
