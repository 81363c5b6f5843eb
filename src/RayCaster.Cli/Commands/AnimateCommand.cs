namespace RayCaster.Cli;

internal sealed class AnimateCommand : Command
{
    public override string Help => """
        Description:
          Joins frames into an animated PNG (APNG), which browsers play. No pixel changes.

        Usage:
          raycaster animate <frame>... -o <file> [options]

        Arguments:
          <frame>...  PNG files drawn by raycaster, all of one size, in order. The files of a
                      pattern or a folder come in the order of their names.

        Options:
          -o, --output <file>  The animation, a .png.
              --fps <n>        Frames per second, 1 to 1000. [default: 25]
          -q, --quiet          Prints errors only.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var output = OutputOf(line, "animate");
        var fps = line.Count(Option.Fps, "frames per second", 1000) ?? 25;
        var frames = FramesOf(line, output);
        PictureOutput.Write(output, cancellation, stream => AnimationFile.Write(stream, frames, fps, cancellation));
        line.Tell($"{output}: {Digits.Count(frames.Count, "frame")}, {(double)frames.Count / fps:0.##} s");
        return ExitCode.Done;
    }

    public static string OutputOf(CommandLine line, string command)
    {
        if (line[Option.Output] is not { } output) throw ProblemException.Usage($"{command} needs a name for the picture, as in -o {command}.png");
        if (output == SceneInput.Standard || PictureFormats.ByExtension(output) != PictureFormat.Png)
            throw ProblemException.Usage($"{command} writes a PNG, to a file: choose a name with .png");
        return output;
    }

    /// <summary>The frames, without the output file of an earlier run.</summary>
    public static List<string> FramesOf(CommandLine line, string output)
    {
        var frames = InputFiles.Of(line.Operands, out var chosen);
        frames.RemoveAll(file => !chosen.Contains(file) && Path.GetFullPath(file) == Path.GetFullPath(output));
        InputFiles.Note(frames);
        return frames.Count > 0 ? frames : throw ProblemException.Usage("no picture is given: name PNG files, a pattern, or a folder with some");
    }
}
