using System.Runtime.CompilerServices;

namespace RayCaster.Cli;

/// <summary>
/// Draws a scene's picture: a small one by the definition, and others with the engine. If a pixel of the engine's differs from the definition, the
/// definition draws them again. In a native program the engine starts at once and draws small pictures, too.
/// </summary>
/// <param name="plain">Whether the definition draws every picture.</param>
/// <param name="manyFrames">Whether many pictures are drawn in this process (<see cref="Renderer.ManyFrames"/>).</param>
internal sealed class Drawing(Scene scene, CommandLine line, bool plain = false, bool manyFrames = false)
{
    /// <summary>The most pixels of which the definition draws the lines at once: so many need little memory.</summary>
    private const int PixelsAtOnce = 1 << 22;

    /// <summary>With no more rays times models, compiling the engine takes longer than drawing by the definition.</summary>
    private const long SmallWork = 3_000_000;

    private readonly int? threads = line.Get(Option.Threads);
    private readonly bool isByDefinition =
        plain || (!manyFrames && RuntimeFeature.IsDynamicCodeCompiled &&
            (double)scene.Camera.Width * scene.Camera.Height * Math.Max(1, scene.ShapeCount) <= SmallWork);

    /// <summary>Draws lines of the picture, and writes them as soon as they are drawn: memory does not grow with their number.</summary>
    /// <param name="part">What the file shows, to be written into it; null for all lines, and for nothing.</param>
    /// <returns>Whether the lines look like a mistake, since they show nothing or one colour.</returns>
    public bool Write(string output, PictureFormat format, PartFacts? part = null)
    {
        var (first, count) = part is null ? (0, scene.Camera.Height) : (part.Lines.First, part.Lines.Count);
        if (DrawInto(isByDefinition, out var isBlank) is not { } difference) return isBlank;
        StandardStreams.WriteError($"raycaster: the engine's picture is not the definition's at {difference}. The definition draws the picture.");
        if (output == StandardStreams.Name) throw new ProblemException("standard output has a wrong picture: write to a file, or add --plain");
        DrawInto(byDefinition: true, out isBlank);
        return isBlank;

        string? DrawInto(bool byDefinition, out bool isBlank)
        {
            var blank = new BlankPicture(scene.Background);
            using var progress = ProgressLine.For(line);
            using var picture = new PictureOutput(output, format, scene.Camera.Width, count, part);
            string? difference = null;
            if (byDefinition) DrawByDefinition(first, count, Take, progress);
            else difference = DrawByEngine(first, count, Take, progress);
            if (difference is null) picture.Finish();
            isBlank = blank.IsBlank;
            return difference;

            void Take(ReadOnlySpan<byte> drawn)
            {
                blank.Take(drawn);
                picture.WriteRows(drawn);
            }
        }
    }

    /// <param name="part">Of a part, which lines.</param>
    public string Summary(string output, int lines, TimeSpan elapsed, string part = "")
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var rays = (double)width * lines / elapsed.TotalSeconds;
        var rate = rays < 1e5 ? $"{rays:N0}" : $"{rays / 1e6:0.0} million"; // of a small picture millions would be 0.0
        return $"{OutputFile.NameOf(output)}: {part}{width} x {height} pixels, " +
            $"{Digits.Count(scene.Models.Count, "model")}, {elapsed.TotalSeconds:0.00} s, {rate} rays per second";
    }

    /// <summary>A method of its own, because the runtime loads the engine when it compiles one that uses it.</summary>
    /// <returns>Where a pixel differs from the definition, so that the lines are wrong; null if they are right.</returns>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private string? DrawByEngine(int first, int count, Action<ReadOnlySpan<byte>> take, ProgressLine? progress) =>
        new Renderer(scene, threads) { ManyFrames = manyFrames }
            .Draw(first..(first + count), take, progress is null ? null : done => progress.LinesDone(done, count));

    private void DrawByDefinition(int first, int count, Action<ReadOnlySpan<byte>> take, ProgressLine? progress)
    {
        var atOnce = Math.Clamp(PixelsAtOnce / scene.Camera.Width, 1, progress is null ? count : Math.Max(1, count / 50));
        for (var next = first; next < first + count; next += atOnce)
        {
            var lines = new Picture(scene.Camera.Width, Math.Min(atOnce, first + count - next));
            ScalarRenderer.Render(scene, lines, 0, next, threads ?? -1);
            progress?.LinesDone(lines.Height, count);
            take(lines.Rgb);
        }
    }
}
