namespace RayCaster.Cli;

internal sealed class DrawCommand : Command
{
    public override string Help => """
        Description:
          Draws a scene: casts one ray for each pixel and writes the picture.

        Usage:
          raycaster [draw] <scene> [options]
          raycaster <command> ...

        For students:
          live <scene>                     Opens a page that redraws the scene when you save it.
          diagnose <scene> <mine>          Names the mistake that makes a picture wrong.
          compare <mine> <reference>       Says whether two pictures are the same, and where not.
          explain <scene> <column> <line>  Shows how one pixel gets its colour.

        For teachers:
          handout <folder>                 Writes the lab for students: ten steps, with tests.
          mark <rubric> <submissions>      Marks a class by its pictures, with a page for each.
          vary <scene>                     Makes a similar scene, one for each student.
          check <scene>...                 Finds errors, and mistakes that a scene cannot show.

        For large pictures and many:
          stitch <part>...                 Joins parts into one picture, or lists missing lines.
          orbit <scene>                    Draws the frames of a moving camera.
          animate <frame>...               Joins frames into an animated PNG.
          sheet <picture>...               Draws small copies of many pictures on one sheet.

          help [command]                   Shows this help, or a command's.

        Arguments:
          <scene>  The scene file (JSON); "-" reads it from standard input.

        Options:
          -o, --output <file>    Where to write the picture: .png or .ppm; "-" writes it to a
                                 redirected standard output, as PPM.
                                 [default: the scene's name with .png, in the current folder]
              --format <format>  png, ppm or ppm-text (PPM in readable numbers).
                                 [default: by the file's extension]
          -s, --size <W>x<H>     Overrides the scene's picture size, in pixels.
              --rows <lines>     Draws only these lines of the picture, a part for "stitch": for
                                 example 0..249 (counted from 0 at the top, both included), or
                                 3/8 (the third of eight parts).
                                 [default output: room.part-0000-0249.png]
              --resume           Does nothing if a complete picture or part of the same scene
                                 exists already.
          -t, --threads <n>      How many threads cast rays. [default: one per core]
              --map <kind>       Writes numbers instead of the picture: t, depth, model, normal
                                 or uv. The files are <scene>.<kind>.pfm and a picture, .png.
              --mistake <ids>    Draws the picture of a program with a mistake, or with several,
                                 for example rows+bgr. docs/mistakes.md lists the mistakes.
              --ledger           Prints which models show, and why the others do not. Also
                                 printed if the picture is empty or has one colour.
              --plain            Draws by the definition, ScalarRenderer, ray by ray: for the
                                 debugger and for Console.WriteLine in a formula.
              --preview          Also shows the picture in the terminal (standard output).
              --color <when>     Colours of the preview: auto, always or never. [default: auto,
                                 which uses NO_COLOR, FORCE_COLOR, COLORTERM and TERM]
          -q, --quiet            Prints errors only.
              --no-progress      Never draws a progress line.
              --version          Shows the version.
          -?, -h, --help         Shows this help. Under "dotnet run" write it after "--".

        Examples:
          dotnet run --project src/RayCaster.Cli -- scenes/room.json
          dotnet run --project src/RayCaster.Cli -- scenes/room.json -o room.ppm --size 1920x1080

        Exit codes:
          0 done, 1 the answer is no (pictures differ, parts are missing), 2 failed,
          70 internal error, 129 hung up, 130 interrupted, 143 terminated.
        """;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        if (line.Operands is not [var path]) throw NotOneScene(line.Operands);
        var isPart = line.Has(Option.Rows) || line.Has(Option.Resume);
        if (line.Has(Option.Map) && isPart)
            throw ProblemException.Usage("a map is drawn whole: leave --rows and --resume out");
        if (line.Has(Option.Mistake) && (line.Has(Option.Map) || isPart))
            throw ProblemException.Usage("a wrong picture is drawn whole: leave --map, --rows and --resume out");
        if (line.Has(Option.Map)) return MapOutput.Run(line, path, cancellation);
        if (line.Has(Option.Mistake)) return MistakeOutput.Run(line, path, cancellation);
        var (threads, quiet) = (line.ThreadCount(), line.Has(Option.Quiet));
        line.Lines(Option.Rows, int.MaxValue); // refuses another form before the scene is read
        var output = line[Option.Output] ?? (line.Has(Option.Rows) ? null : NameOf(path) + ".png"); // the name of a part needs the picture's height
        var format = PictureOutput.FormatOf(line, output ?? ".png", isPart ? PictureFormat.Png : PictureFormat.Ppm);
        if (isPart && format != PictureFormat.Png)
            throw ProblemException.Usage("--rows and --resume write a PNG, which records what it shows; choose another name or format");
        if (output == SceneInput.Standard && line.Has(Option.Resume))
            throw ProblemException.Usage("--resume needs a file: it cannot check what was written to standard output");
        var colors = TerminalScreen.Colors(line);
        if (line.Has(Option.Preview) && output == SceneInput.Standard)
            throw ProblemException.Usage("--preview and -o - both write to standard output: write the picture to a file");

        if (SceneInput.Read(path, line, cancellation) is not { } scene) return ExitCode.CouldNot;

        var lines = line.Lines(Option.Rows, scene.Camera.Height);
        output ??= PartName(NameOf(path), lines, scene.Camera.Height);
        var start = Stopwatch.GetTimestamp();
        var part = isPart ? PartFacts.Of(scene, lines, SceneDigest.OfModels(scene.Models), typeof(Renderer).Assembly) : null;
        if (line.Has(Option.Resume) && PictureOutput.IsUpToDate(output, part!, quiet))
        {
            line.Tell($"{output}: exists already");
            return ExitCode.Done;
        }

        var (odd, preview) = (default(OddPicture), default(TerminalPreview));
        scene = SpatialOrder.Of(scene);
        var renderer = new CheckedRenderer(scene, threads, line.Has(Option.Plain));
        PictureOutput.Draw(output, format, renderer, lines, part, line, cancellation, Watch);
        if (preview is not null) TerminalScreen.Show(preview, colors);
        if (quiet) return ExitCode.Done;
        StandardStreams.WriteError(Summary(output, scene, lines, Stopwatch.GetElapsedTime(start)));
        var isOdd = odd!.IsOdd && lines.Count == scene.Camera.Height; // a part may have one colour without a mistake
        if (line.Has(Option.Ledger) || (isOdd && HitLedger.IsQuick(scene))) StandardStreams.WriteError(HitLedger.Take(scene, cancellation).Report());
        else if (isOdd)
            StandardStreams.WriteError("The picture shows nothing, or one colour; --ledger says why, which takes a while with so many triangles.");
        return ExitCode.Done;

        Action<ReadOnlySpan<byte>> Watch()
        {
            odd = new(scene.Background);
            preview = line.Has(Option.Preview) ? TerminalScreen.Preview(scene.Camera.Width, lines.Count) : null;
            return drawn =>
            {
                odd.Take(drawn);
                preview?.Take(drawn);
            };
        }
    }

    private static ProblemException NotOneScene(IReadOnlyList<string> operands) => operands switch
    {
        [] => ProblemException.Usage("no scene is given: name a scene file, for example scenes/room.json"),
        [_, _, ..] when File.Exists(string.Join(' ', operands)) =>
            ProblemException.Usage($"a file's name with blanks stands in quotes: \"{string.Join(' ', operands)}\""),
        [var word, ..] when Spelling.Nearest(word, Command.All.Keys) is { } name =>
            ProblemException.Usage($"there is no command '{word}'; did you mean '{name}'?"),
        [var word, ..] when !File.Exists(word) && word.All(char.IsAsciiLetter) =>
            ProblemException.Usage($"there is no command '{word}'; a scene is drawn without one"),
        var scenes => ProblemException.Usage(
            $"one scene at a time, but there are {scenes.Count}: {string.Join(", ", scenes)}{OutputHint(scenes)}"),
    };

    private static string OutputHint(IReadOnlyList<string> operands) =>
        operands is [_, var second] && Path.GetExtension(second).ToLowerInvariant() is ".png" or ".ppm"
            ? $"; did you mean -o {second}?"
            : "";

    /// <summary>The name of a scene's pictures: its file name without folder and extension.</summary>
    public static string NameOf(string scene) => scene == SceneInput.Standard ? "scene" : Path.GetFileNameWithoutExtension(scene);

    /// <summary>For example room.part-0000-0249.png.</summary>
    private static string PartName(string name, LineRange lines, int height) =>
        $"{name}.part-{Padded(lines.First, height)}-{Padded(lines.Last, height)}.png";

    /// <summary>A number of 0 to count − 1 for a file's name: all have one length, so the files sort in order.</summary>
    public static string Padded(int number, int count) => number.ToString($"D{Math.Max(4, $"{count - 1}".Length)}");

    private static string Summary(string output, Scene scene, LineRange lines, TimeSpan elapsed)
    {
        var (width, height, models) = (scene.Camera.Width, scene.Camera.Height, scene.Models.Count);
        return $"{PictureOutput.NameOf(output)}: {(lines.Count == height ? "" : $"lines {lines} of ")}{width} x {height} pixels, " +
            $"{Digits.Count(models, "model")}, {elapsed.TotalSeconds:0.00} s, {ProgressLine.Rate((double)width * lines.Count, "rays", elapsed)}";
    }
}
