using System.Diagnostics;
using System.Globalization;

namespace RayCaster.Cli;

/// <summary>Reads a scene, draws it, writes the picture.</summary>
internal sealed class DrawCommand(CommandLine line)
{
    private const string Standard = "-";

    /// <exception cref="ProblemException">The scene does not do, or nobody takes the picture.</exception>
    /// <exception cref="PictureFileException">The picture's file does not do.</exception>
    public int Run(CancellationToken cancellation)
    {
        var output = line.Output ?? DefaultOutput();
        var format = line.Format ?? (output == Standard ? PictureFormat.Ppm : PictureFormats.ByExtension(output));
        if (output == Standard && !Console.IsOutputRedirected)
            throw new ProblemException(
                "raycaster: a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");

        // Reading leaves nothing behind, so an interruption need not wait for its end: standard input may have none.
        var scene = Task.Run(ReadScene).WaitAsync(cancellation).GetAwaiter().GetResult();
        if (scene is null) return ExitCode.CouldNot;

        var start = Stopwatch.GetTimestamp();
        try
        {
            if (output == Standard)
            {
                using var stream = StandardFile.OpenOutput();
                try
                {
                    Draw(scene, stream, format, cancellation);
                }
                finally
                {
                    StandardFile.Leave(stream);
                }
            }
            else
            {
                using var file = new ReplacedFile(output);
                Draw(scene, file, format, cancellation);
                file.Commit();
            }
        }
        catch (IOException problem) when (output == Standard)
        {
            throw new ProblemException($"raycaster: cannot write to standard output: {problem.Message}");
        }

        if (!line.Quiet) StandardFile.WriteError(Summary(output, scene, Stopwatch.GetElapsedTime(start)) + Environment.NewLine);
        return ExitCode.Done;
    }

    private string DefaultOutput() =>
        (line.Scene == Standard ? "scene" : Path.GetFileNameWithoutExtension(line.Scene)) + ".png";

    /// <summary>The scene, or null after its errors have been printed.</summary>
    private Scene? ReadScene()
    {
        var reading = line.Scene == Standard ? ReadStandardInput() : SceneReader.Read(line.Scene);
        if (reading.Scene is null || !line.Quiet) StandardFile.WriteError(reading.Report());
        if (reading.Scene is not { } scene || line.Size is not var (width, height)) return reading.Scene;
        return scene with { Camera = scene.Camera.WithSize(width, height) };
    }

    private static SceneReading ReadStandardInput()
    {
        using var input = Console.OpenStandardInput();
        using var bytes = new MemoryStream();
        input.CopyTo(bytes);
        return SceneReader.Parse(bytes.ToArray(), "<stdin>", Environment.CurrentDirectory);
    }

    private void Draw(Scene scene, Stream output, PictureFormat format, CancellationToken cancellation)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        using var progress = line.Quiet || line.NoProgress || !ProgressLine.IsWanted
            ? null
            : new ProgressLine(Console.Error, width, height, TerminalWidth(), TimeProvider.System);
        using var writer = PictureWriter.Create(format, output, width, height);
        new Renderer(scene, line.Threads).Draw(writer.WriteRows, progress is null ? null : progress.LinesDone, cancellation);
        writer.Finish();
    }

    private static int TerminalWidth()
    {
        try
        {
            return Console.WindowWidth;
        }
        catch (IOException)
        {
            return 0;
        }
    }

    /// <summary>One line: picture, size, models, time, rays per second.</summary>
    private static string Summary(string output, Scene scene, TimeSpan elapsed)
    {
        var (width, height, models) = (scene.Camera.Width, scene.Camera.Height, scene.Models.Count);
        var rays = (double)width * height / elapsed.TotalSeconds;
        return string.Create(CultureInfo.InvariantCulture,
            $"{(output == Standard ? "standard output" : output)}: {width} x {height} pixels, " +
            $"{models} {(models == 1 ? "model" : "models")}, " +
            $"{elapsed.TotalSeconds:0.00} s, {rays / 1e6:0.0} million rays per second");
    }
}
