namespace RayCaster.Cli;

/// <summary>Writes pictures: to a file, which is complete or unchanged, or to standard output.</summary>
internal static class PictureOutput
{
    /// <summary>Refuses standard output where it is a terminal.</summary>
    /// <param name="output">The file, or "-"; null if it has no name yet.</param>
    /// <exception cref="ProblemException">It is a terminal.</exception>
    public static void KeepOffTerminal(string? output)
    {
        if (output == SceneInput.Standard && TerminalScreen.TakesOutput)
            throw new ProblemException(
                "raycaster: a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");
    }

    /// <summary>Its name in messages.</summary>
    public static string NameOf(string output) => output == SceneInput.Standard ? "standard output" : output;

    /// <summary>Opens the output, writes it and closes it.</summary>
    /// <param name="output">The file, or "-".</param>
    /// <param name="cancellation">If cancelled, the old file stays.</param>
    /// <param name="write">Writes the picture.</param>
<<<<<<< HEAD
    /// <param name="found">What killed runs have left in the file's folder; null: it is listed.</param>
    /// <exception cref="ProblemException">Nobody takes the picture, or it would replace a file that was read.</exception>
    /// <exception cref="PictureFileException">The file does not do.</exception>
    public static void Write(string output, CancellationToken cancellation, Action<Stream> write, TemporaryFileList? found = null)
=======
    /// <exception cref="ProblemException">Standard output cannot be written, or the picture would replace a file that was read.</exception>
    /// <exception cref="PictureFileException">The file cannot be written.</exception>
    public static void Write(string output, CancellationToken cancellation, Action<Stream> write)
>>>>>>> 3551bc04121148c4b248d8a629ca3d00a8a082d8
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

<<<<<<< HEAD
    /// <summary>Writes a picture that is there already.</summary>
    /// <inheritdoc cref="Write(string, CancellationToken, Action{Stream}, TemporaryFileList?)"/>
=======
    /// <summary>Writes a picture.</summary>
    /// <inheritdoc cref="Write(string, CancellationToken, Action{Stream})"/>
>>>>>>> 3551bc04121148c4b248d8a629ca3d00a8a082d8
    public static void Write(string output, Picture picture, PictureFormat format, CancellationToken cancellation) =>
        Write(output, cancellation, stream =>
    {
        using var writer = PictureWriter.Create(format, stream, picture.Width, picture.Height);
        writer.WriteRows(picture.Rgb);
        writer.Finish();
    });

    /// <summary>Draws some lines of a scene's picture.</summary>
    /// <param name="output">The file, or "-".</param>
    /// <param name="format">The picture format.</param>
    /// <param name="renderer">Draws the scene.</param>
    /// <param name="lines">Which lines.</param>
    /// <param name="part">What the file shows, to be written into it; null for nothing.</param>
    /// <param name="showProgress">Whether to show a progress line.</param>
    /// <param name="cancellation">Stops the work.</param>
<<<<<<< HEAD
    /// <param name="watch">Sees the lines too, from the first to the last, and again from the first if the picture is drawn anew.</param>
    /// <param name="found">What killed runs have left in the file's folder; null: it is listed.</param>
=======
    /// <param name="watch">Also gets the lines in order; again from the first line if the picture is drawn again.</param>
>>>>>>> 3551bc04121148c4b248d8a629ca3d00a8a082d8
    public static void Draw(string output, PictureFormat format, CheckedRenderer renderer, LineRange lines, PartFacts? part,
        bool showProgress, CancellationToken cancellation, Action<int, ReadOnlySpan<byte>>? watch = null, TemporaryFileList? found = null)
    {
        if (output == SceneInput.Standard) renderer.CheckInAdvance(lines, cancellation); // lines on standard output cannot be replaced later
        try
        {
            Write(output, cancellation, WriteOnce, found);
        }
        catch (FastWayDisagreesException)
        {
<<<<<<< HEAD
            Write(output, cancellation, WriteOnce, found); // the file was not put in place yet
=======
            Write(output, cancellation, WriteOnce); // the file has not replaced the old one yet
>>>>>>> 3551bc04121148c4b248d8a629ca3d00a8a082d8
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

    /// <summary>Whether the picture exists already and need not be drawn. If a file exists but has other content, prints why it is drawn again.</summary>
    public static bool IsThere(string output, PartFacts part, bool quiet)
    {
        if (PartFile.Holds(output, part, out var reason)) return true;
        if (reason is not null && !quiet) StandardFile.WriteError($"{output} is drawn anew: {reason}\n");
        return false;
    }

    /// <summary>What a part shows, to be written into its file.</summary>
    /// <exception cref="ProblemException">A model cannot describe its numbers.</exception>
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
