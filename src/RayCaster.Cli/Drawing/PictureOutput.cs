namespace RayCaster.Cli;

/// <summary>Draws and writes pictures.</summary>
internal static class PictureOutput
{
    /// <summary>The format of --format, or that of the file's extension; PPM for standard output.</summary>
    public static PictureFormat FormatOf(string output, PictureFormat? format)
    {
        if (output == StandardStreams.Name && !Console.IsOutputRedirected)
            throw new ProblemException(
                "a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");
        return format ?? (output == StandardStreams.Name ? PictureFormat.Ppm
            : Directory.Exists(output) ? throw new ProblemException($"cannot write {output}: it is a folder; name a file in it")
            : PictureFormats.ByExtension(output));
    }

    public static void Write(string output, Picture picture, PictureFormat format) =>
        OutputFile.Write(output, stream => PictureFile.Write(stream, picture, format));

    /// <summary>Draws some lines of a scene's picture.</summary>
    /// <param name="part">What the file shows, to be written into it; null for nothing.</param>
    /// <returns>Whether the lines look like a mistake, since they show nothing or one colour.</returns>
    public static bool Draw(string output, PictureFormat format, RendererChoice renderer, NumberRange lines, PartFacts? part,
        CommandLine line)
    {
        var odd = default(BlankPicture);
        OutputFile.Write(output, stream =>
        {
            if (WriteTo(stream, plain: false) is not { } difference) return;
            StandardStreams.WriteError(
                $"raycaster: the engine's picture is not the definition's at {difference}. The definition draws the picture.");
            if (output == StandardStreams.Name) throw new ProblemException("standard output has a wrong picture: write to a file, or add --plain");
            stream.SetLength(0);
            WriteTo(stream, plain: true);
        });
        return odd!.IsBlank;

        string? WriteTo(Stream stream, bool plain)
        {
            var (width, height) = (renderer.Scene.Camera.Width, lines.Count);
            odd = new(renderer.Scene.Background);
            using var progress = ProgressLine.For(line);
            using var writer = PictureWriter.Create(format, stream, width, height, part?.PngText);
            var difference = renderer.Draw(lines, Take, done => progress?.LinesDone(done, height), plain);
            writer.Finish();
            return difference;

            void Take(ReadOnlySpan<byte> drawn)
            {
                odd.Take(drawn);
                writer.WriteRows(drawn);
            }
        }
    }

    /// <summary>What was drawn, in a line.</summary>
    public static string Summary(string output, Scene scene, NumberRange lines, TimeSpan elapsed)
    {
        var (width, height) = (scene.Camera.Width, scene.Camera.Height);
        var rays = (double)width * lines.Count / elapsed.TotalSeconds;
        var rate = rays < 1e5 ? $"{rays:N0}" : $"{rays / 1e6:0.0} million"; // of a small picture millions would be 0.0
        return $"{OutputFile.NameOf(output)}: {(lines.Count == height ? "" : $"lines {lines} of ")}{width} x {height} pixels, " +
            $"{Digits.Count(scene.Models.Count, "model")}, {elapsed.TotalSeconds:0.00} s, {rate} rays per second";
    }

    /// <summary>Whether the picture exists already and need not be drawn. If a file exists but has other content, prints why it is drawn
    /// again.</summary>
    public static bool IsUpToDate(string output, PartFacts part, bool quiet)
    {
        if (PartFile.Holds(output, part, out var reason)) return true;
        if (reason is not null && !quiet) StandardStreams.WriteError($"{output} is drawn again: {reason}");
        return false;
    }

    /// <summary>A number of 0 to count − 1 for a file's name: all have one length, so the files sort in order.</summary>
    public static string Padded(int number, int count) => number.ToString($"D{Math.Max(4, $"{count - 1}".Length)}");
}
