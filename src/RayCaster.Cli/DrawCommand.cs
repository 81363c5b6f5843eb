namespace RayCaster.Cli;

internal sealed class DrawCommand : Command
{
    public override string Help => HelpText.Full;

    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var path = ScenePath(line);
        if (line.Has(Option.Map) && (line.Has(Option.Rows) || line.Has(Option.Resume)))
            throw ProblemException.Usage("a map is drawn whole: leave --rows and --resume out");
        if (line.Has(Option.Mistake) && (line.Has(Option.Map) || line.Has(Option.Rows) || line.Has(Option.Resume)))
            throw ProblemException.Usage("a wrong picture is drawn whole: leave --map, --rows and --resume out");
        if (line.Has(Option.Map)) return MapOutput.Run(line, path, cancellation);
        if (line.Has(Option.Mistake)) return MistakeOutput.Run(line, path, cancellation);
        var (threads, quiet, rows) = (line.ThreadCount(), line.Has(Option.Quiet), line[Option.Rows]);
        if (rows is not null) Rows.Of(rows, int.MaxValue); // refuses another form before the scene is read
        var isPart = rows is not null || line.Has(Option.Resume);
        var output = line[Option.Output] ?? (rows is null ? NameOf(path) + ".png" : null); // the name of a part needs the picture's height
        var format = Format(line, output, isPart);
        if (output == SceneInput.Standard && line.Has(Option.Resume))
            throw ProblemException.Usage("--resume needs a file: it cannot check what was written to standard output");
        PictureOutput.KeepOffTerminal(output);

        var colors = TerminalScreen.Colors(line);
        if (line.Has(Option.Preview) && output == SceneInput.Standard)
            throw ProblemException.Usage("--preview and -o - both write to standard output: write the picture to a file");

        if (SceneInput.Read(path, line, cancellation) is not { } scene) return ExitCode.CouldNot;

        var lines = rows is null ? LineRange.Whole(scene.Camera.Height) : Rows.Of(rows, scene.Camera.Height);
        output ??= PartName(NameOf(path), lines, scene.Camera.Height);
        var start = Stopwatch.GetTimestamp();
        var part = isPart ? PartFacts.Of(scene, lines, PictureOutput.DigestOfModels(scene)) : null;
        if (line.Has(Option.Resume) && PictureOutput.IsThere(output, part!, quiet))
        {
            line.Tell($"{output}: exists already");
            return ExitCode.Done;
        }

        var (odd, preview) = (default(OddPicture), default(TerminalPreview));
        scene = SpatialOrder.Of(scene, threads);
        var renderer = new CheckedRenderer(scene, threads, line.Has(Option.Plain));
        PictureOutput.Draw(
            output, format, renderer, lines, part, line.ShowsProgress, cancellation, quiet && !line.Has(Option.Preview) ? null : Watch);
        if (preview is not null) TerminalScreen.Show(preview, colors);
        if (quiet) return ExitCode.Done;
        StandardFile.WriteError(Summary(output, scene, lines, Stopwatch.GetElapsedTime(start)) + Environment.NewLine);
        var isOdd = odd!.IsOdd && lines.Count == scene.Camera.Height; // a part may have one colour without a mistake
        if (line.Has(Option.Ledger) || (isOdd && HitLedger.IsQuick(scene))) StandardFile.WriteError(HitLedger.Take(scene, cancellation).Report());
        else if (isOdd)
            StandardFile.WriteError("The picture shows nothing, or one colour; --ledger says why, which takes a while with so many triangles.\n");
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

    private static string ScenePath(CommandLine line) => line.Operands is [var scene] ? scene : throw NotOneScene(line.Operands);

    private static ProblemException NotOneScene(IReadOnlyList<string> operands) => operands switch
    {
        [] => ProblemException.Usage("no scene is given: name a scene file, for example scenes/room.json"),
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

    /// <summary>The picture format. Parts, and pictures drawn with --resume, must be PNG files, which contain what they show.</summary>
    private static PictureFormat Format(CommandLine line, string? output, bool isPart)
    {
        var format = isPart && output is null or SceneInput.Standard ? line.PictureFormat() ?? PictureFormat.Png
            : PictureOutput.FormatOf(line, output!);
        return !isPart || format == PictureFormat.Png ? format
            : throw ProblemException.Usage("--rows and --resume write a PNG, which records what it shows; choose another name or format");
    }

    /// <summary>The name of a scene's pictures: its file name without folder and extension.</summary>
    public static string NameOf(string scene) => scene == SceneInput.Standard ? "scene" : Path.GetFileNameWithoutExtension(scene);

    /// <summary>For example room.part-0000-0249.png.</summary>
    private static string PartName(string name, LineRange lines, int height) =>
        $"{name}.part-{Padded(lines.First, height)}-{Padded(lines.Last, height)}.png";

    /// <summary>A number of 0 to count − 1 for a file's name: all have one length, so the files sort in order.</summary>
    public static string Padded(int number, int count) =>
        number.ToString($"D{Math.Max(4, (count - 1).ToString(CultureInfo.InvariantCulture).Length)}", CultureInfo.InvariantCulture);

    /// <summary>One line: picture, size, models, time, rays per second.</summary>
    private static string Summary(string output, Scene scene, LineRange lines, TimeSpan elapsed)
    {
        var (width, height, models) = (scene.Camera.Width, scene.Camera.Height, scene.Models.Count);
        var rays = (double)width * lines.Count / elapsed.TotalSeconds;
        return string.Create(CultureInfo.InvariantCulture,
            $"{PictureOutput.NameOf(output)}: {(lines.Count == height ? "" : $"lines {lines} of ")}{width} x {height} pixels, " +
            $"{models} {(models == 1 ? "model" : "models")}, " +
            $"{elapsed.TotalSeconds:0.00} s, {rays / 1e6:0.0} million rays per second");
    }
}
