namespace RayCaster.Cli;

/// <summary>Writes pictures: to a file, which is complete or unchanged, or to standard output.</summary>
internal static class PictureOutput
{
    /// <summary>Its name in messages.</summary>
    public static string NameOf(string output) => output == SceneInput.Standard ? "standard output" : output;

    /// <summary>The format of --format, or that of the file's extension.</summary>
    /// <param name="ofStandardOutput">The format of standard output without --format.</param>
    public static PictureFormat FormatOf(CommandLine line, string output, PictureFormat ofStandardOutput = PictureFormat.Ppm)
    {
        if (output == SceneInput.Standard && !Console.IsOutputRedirected)
            throw new ProblemException(
                "a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");
        return line.Format() ?? (output == SceneInput.Standard ? ofStandardOutput
            : Directory.Exists(output) ? throw new ProblemException($"cannot write {output}: it is a folder; name a file in it")
            : PictureFormats.ByExtension(output));
    }

    /// <param name="cancellation">If cancelled, the old file stays.</param>
    public static void Write(string output, CancellationToken cancellation, Action<Stream> write)
    {
        if (output == SceneInput.Standard)
        {
            StandardStreams.WriteOutput(write);
            return;
        }
        InputFiles.ThrowIfInput(output);
        WrittenFiles.Write(output, write, cancellation);
    }

    public static void Write(string output, Picture picture, PictureFormat format, CancellationToken cancellation) =>
        Write(output, cancellation, stream => PictureFile.Write(stream, picture, format));

    /// <summary>Draws some lines of a scene's picture.</summary>
    /// <param name="part">What the file shows, to be written into it; null for nothing.</param>
    /// <param name="watch">Gives what also gets the lines, in order; called again if the picture is drawn again.</param>
    public static void Draw(string output, PictureFormat format, CheckedRenderer renderer, LineRange lines, PartFacts? part,
        CommandLine line, CancellationToken cancellation, Func<Action<ReadOnlySpan<byte>>>? watch = null)
    {
        try
        {
            Write(output, cancellation, WriteOnce);
        }
        catch (EngineDisagreesException)
        {
            if (output == SceneInput.Standard) throw new ProblemException("standard output has a wrong picture: write to a file, or add --plain");
            Write(output, cancellation, WriteOnce); // the file has not replaced the old one yet
        }

        void WriteOnce(Stream stream)
        {
            var (width, height, watcher) = (renderer.Scene.Camera.Width, lines.Count, watch?.Invoke());
            using var progress = ProgressLine.For(line, width, height);
            using var writer = PictureWriter.Create(format, stream, width, height, part?.ToString());
            renderer.Draw(lines, Take, done => progress?.LinesDone(done), cancellation);
            writer.Finish();

            void Take(ReadOnlySpan<byte> drawn)
            {
                watcher?.Invoke(drawn);
                writer.WriteRows(drawn);
            }
        }
    }

    /// <summary>Whether the picture exists already and need not be drawn. If a file exists but has other content, prints why it is drawn
    /// again.</summary>
    public static bool IsUpToDate(string output, PartFacts part, bool quiet)
    {
        if (PartFile.Holds(output, part, out var reason)) return true;
        if (reason is not null && !quiet) StandardStreams.WriteError($"{output} is drawn again: {reason}");
        return false;
    }
}
