using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Cli;

/// <summary>Reads a scene, draws it, writes the picture.</summary>
internal sealed class DrawCommand : Command
{
    public override IReadOnlyList<Option> Options { get; } =
        [Option.Output, Option.Format, Option.Size, Option.Threads, Option.Quiet, Option.NoProgress, Option.Map, Option.Ledger, Option.Preview, Option.Color, Option.Version];

    public override string Help => HelpText.Full;

    /// <exception cref="ProblemException">The scene does not do, or nobody takes the picture.</exception>
    /// <exception cref="PictureFileException">The picture's file does not do.</exception>
    public override int Run(CommandLine line, CancellationToken cancellation)
    {
        var path = ScenePath(line);
        if (line.Has(Option.Map)) return MapOutput.Run(line, path, cancellation);
        var (size, threads, quiet) = (line.PictureSize(), line.ThreadCount(), line.Has(Option.Quiet));
        var output = line[Option.Output] ?? NameOf(path) + ".png";
        var format = Format(line[Option.Format]) ?? (output == SceneInput.Standard ? PictureFormat.Ppm : PictureFormats.ByExtension(output));
        if (output == SceneInput.Standard && !Console.IsOutputRedirected)
            throw new ProblemException(
                "raycaster: a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");

        var colors = TerminalScreen.Colors(line);
        if (line.Has(Option.Preview) && output == SceneInput.Standard)
            throw ProblemException.Usage("--preview and -o - both want standard output: write the picture to a file");

        if (SceneInput.Read(path, size, quiet, cancellation) is not { } scene) return ExitCode.CouldNot;

        var odd = new OddPicture(scene.Background);
        var preview = line.Has(Option.Preview) ? TerminalScreen.Preview(scene.Camera.Width, scene.Camera.Height) : null;
        var start = Stopwatch.GetTimestamp();
        var showProgress = !quiet && !line.Has(Option.NoProgress) && ProgressLine.IsWanted;
        if (output == SceneInput.Standard)
        {
            // Who cancels does not wait until a reader that has stopped reads on; what it has not got nobody misses.
            Task.Run(() => StandardFile.WriteOutput(stream => Draw(scene, threads, stream, format, Watch, showProgress, cancellation)))
                .WaitAsync(cancellation).GetAwaiter().GetResult();
        }
        else
        {
            using var file = new ReplacedFile(output);
            Draw(scene, threads, file, format, Watch, showProgress, cancellation);
            file.Commit();
        }

        if (preview is not null) TerminalScreen.Show(preview, colors);
        if (quiet) return ExitCode.Done;
        StandardFile.WriteError(Summary(output, scene, Stopwatch.GetElapsedTime(start)) + Environment.NewLine);
        if (line.Has(Option.Ledger) || odd.IsOdd) StandardFile.WriteError(HitLedger.Take(scene, cancellation).Report());
        return ExitCode.Done;

        void Watch(ReadOnlySpan<byte> lines)
        {
            odd.Take(lines);
            preview?.Take(lines);
        }
    }

    private static string ScenePath(CommandLine line) => line.Operands switch
    {
        [var scene] when scene.Length > 0 => scene,
        [] or [_] => throw ProblemException.Usage("which scene? Name a scene file, for example scenes/room.json"),
        [var word, ..] when Spelling.Nearest(word, Command.Names) is { } name =>
            throw ProblemException.Usage($"there is no command '{word}'; did you mean '{name}'?"),
        var scenes => throw ProblemException.Usage(
            $"one scene at a time, but there are {scenes.Count}: {string.Join(", ", scenes)}{OutputHint(scenes)}"),
    };

    private static string OutputHint(IReadOnlyList<string> operands) =>
        operands is [_, var second] && Path.GetExtension(second).ToLowerInvariant() is ".png" or ".ppm"
            ? $"; did you mean -o {second}?"
            : "";

    private static PictureFormat? Format(string? text) => text switch
    {
        null => null,
        "png" => PictureFormat.Png,
        "ppm" => PictureFormat.Ppm,
        "ppm-text" => PictureFormat.PpmText,
        _ => throw ProblemException.Usage($"'{text}' is not a format: choose png, ppm or ppm-text"),
    };

    /// <summary>What a scene's pictures are called: as its file is, without folder and extension.</summary>
    public static string NameOf(string scene) => scene == SceneInput.Standard ? "scene" : Path.GetFileNameWithoutExtension(scene);

    private static void Draw(
        Scene scene, int? threads, Stream output, PictureFormat format, Action<ReadOnlySpan<byte>> watch, bool showProgress, CancellationToken cancellation)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        using var progress = showProgress ? new ProgressLine(Console.Error, width, height, TerminalScreen.Width(), TimeProvider.System) : null;
        using var writer = PictureWriter.Create(format, output, width, height);
        new Renderer(scene, threads).Draw(Take, progress is null ? null : progress.LinesDone, cancellation);
        writer.Finish();

        void Take(ReadOnlySpan<byte> lines)
        {
            watch(lines);
            writer.WriteRows(lines);
        }
    }

    /// <summary>One line: picture, size, models, time, rays per second.</summary>
    private static string Summary(string output, Scene scene, TimeSpan elapsed)
    {
        var (width, height, models) = (scene.Camera.Width, scene.Camera.Height, scene.Models.Count);
        var rays = (double)width * height / elapsed.TotalSeconds;
        return string.Create(CultureInfo.InvariantCulture,
            $"{(output == SceneInput.Standard ? "standard output" : output)}: {width} x {height} pixels, " +
            $"{models} {(models == 1 ? "model" : "models")}, " +
            $"{elapsed.TotalSeconds:0.00} s, {rays / 1e6:0.0} million rays per second");
    }
}
