namespace RayCaster.Cli;

/// <summary>A picture that is written from the top, some lines at a time, to a file, which is complete or unchanged, or to standard
/// output.</summary>
/// <param name="part">What the file shows, to be written into it; null for nothing.</param>
internal sealed class PictureOutput(string output, PictureFormat format, int width, int height, PartFacts? part = null) : IDisposable
{
    private readonly OutputFile file = new(output);
    private PictureWriter? writer; // made for the first lines, because its header may fail, too

    public static PictureFormat FormatOf(string output, PictureFormat? format)
    {
        if (output == StandardStreams.Name && !Console.IsOutputRedirected)
            throw new ProblemException(
                "a terminal cannot show picture bytes\n  Use -o FILE, or redirect them: -o - > picture.ppm");
        return format ?? (output == StandardStreams.Name ? PictureFormat.Ppm
            : Directory.Exists(output) ? throw new ProblemException($"cannot write {output}: it is a folder; name a file in it")
            : PictureFile.FormatOf(output));
    }

    public static void Write(string output, Picture picture, PictureFormat format)
    {
        using var file = new PictureOutput(output, format, picture.Width, picture.Height);
        file.WriteRows(picture.Rgb);
        file.Finish();
    }

    /// <inheritdoc cref="PictureWriter.WriteRows"/>
    public void WriteRows(ReadOnlySpan<byte> rgb) => file.Write(rgb, (stream, rows) =>
    {
        writer ??= PictureWriter.Create(format, stream, width, height, part?.PngText);
        writer.WriteRows(rows);
    });

    public void Finish()
    {
        file.Write([], (_, _) => writer!.Finish());
        file.Finish();
    }

    public void Dispose()
    {
        writer?.Dispose();
        file.Dispose();
    }
}
