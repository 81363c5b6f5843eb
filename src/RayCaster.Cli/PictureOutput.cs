namespace RayCaster.Cli;

/// <summary>Where a picture goes: a file that is there whole or not at all, or standard output.</summary>
internal static class PictureOutput
{
    /// <summary>Refuses standard output where it is a terminal.</summary>
    /// <param name="output">The file, or "-"; null if it has no name yet.</param>
    /// <exception cref="ProblemException">It is one.</exception>
    public static void KeepOffTerminal(string? output)
    {
        if (output == SceneInput.Standard && TerminalScreen.TakesOutput)
            throw new ProblemException(
                "raycaster: a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");
    }

    /// <summary>What messages call it.</summary>
    public static string NameOf(string output) => output == SceneInput.Standard ? "standard output" : output;

    /// <summary>Opens it, has it written and closes it.</summary>
    /// <param name="output">The file, or "-".</param>
    /// <param name="cancellation">Keeps the file from being put in the place of the old one.</param>
    /// <param name="write">Writes the picture.</param>
    /// <param name="found">What killed runs have left in the file's folder; null: it is listed.</param>
    /// <exception cref="ProblemException">Nobody takes the picture, or it would replace a file that was read.</exception>
    /// <exception cref="PictureFileException">The file does not do.</exception>
    public static void Write(string output, CancellationToken cancellation, Action<Stream> write, TemporaryFileList? found = null)
    {
        if (output == SceneInput.Standard)
        {
            StandardFile.WriteOutput(write);
            return;
        }
        InputFiles.Keep(output);
        using var file = new ReplacedFile(output, found);
        write(file);
        cancellation.ThrowIfCancellationRequested();
        file.Commit();
    }

    /// <summary>Writes a picture that is there already.</summary>
    /// <inheritdoc cref="Write(string, CancellationToken, Action{Stream}, TemporaryFileList?)"/>
    public static void Write(string output, Picture picture, PictureFormat format, CancellationToken cancellation) =>
        Write(output, cancellation, stream =>
    {
        using var writer = PictureWriter.Create(format, stream, picture.Width, picture.Height);
        writer.WriteRows(picture.Rgb);
        writer.Finish();
    });

    /// <summary>Draws some lines of a scene's picture.</summary>
    /// <param name="output">The file, or "-".</param>
    /// <param name="format">Its kind.</param>
    /// <param name="renderer">Draws the scene.</param>
    /// <param name="lines">Which lines.</param>
    /// <param name="part">What the file is to say of itself, if anything.</param>
    /// <param name="showProgress">Whether to tell on the terminal how far it is.</param>
    /// <param name="cancellation">Stops the work.</param>
    /// <param name="watch">Sees the lines too, from the first to the last, and again from the first if the picture is drawn anew.</param>
    /// <param name="found">What killed runs have left in the file's folder; null: it is listed.</param>
    public static void Draw(string output, PictureFormat format, CheckedRenderer renderer, LineRange lines, PartFacts? part,
        bool showProgress, CancellationToken cancellation, Action<int, ReadOnlySpan<byte>>? watch = null, TemporaryFileList? found = null)
    {
        if (output == SceneInput.Standard) renderer.CheckInAdvance(lines, cancellation); // what is written there cannot be taken back
        try
        {
            Write(output, cancellation, WriteOnce, found);
        }
        catch (FastWayDisagreesException)
        {
            Write(output, cancellation, WriteOnce, found); // the file was not put in place yet
        }

        void WriteOnce(Stream stream)
        {
            var (width, height, line) = (renderer.Scene.Camera.Width, lines.Count, 0);
            using var progress = showProgress ? ProgressLine.OnTerminal(width, height) : null;
            using var writer = PictureWriter.Create(format, stream, width, height, part);
            renderer.Draw(lines, Take, progress is null ? null : progress.LinesDone, cancellation);
            writer.Finish();

            void Take(ReadOnlySpan<byte> drawn)
            {
                watch?.Invoke(line, drawn);
                writer.WriteRows(drawn);
                line += drawn.Length / (3 * width);
            }
        }
    }

    /// <summary>Whether a picture need not be drawn since it is there; where a file is there but does not do, it says why.</summary>
    public static bool IsThere(string output, PartFacts part, bool quiet)
    {
        if (PartFile.Holds(output, part, out var reason)) return true;
        if (reason is not null && !quiet) StandardFile.WriteError($"{output} is drawn anew: {reason}\n");
        return false;
    }

    /// <summary>What a part says of itself.</summary>
    /// <exception cref="ProblemException">A model does not say what it is made of.</exception>
    public static PartFacts Facts(Scene scene, LineRange lines)
    {
        try
        {
            return PartFacts.Of(scene, lines);
        }
        catch (NotSupportedException e)
        {
            throw new ProblemException($"raycaster: the scene cannot be drawn in parts: {e.Message}");
        }
    }
}
