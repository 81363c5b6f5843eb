namespace RayCaster.Files;

/// <summary>A PNG that holds some lines of a picture (<see cref="PartFacts"/>). Its lines are read one by one.</summary>
public sealed class PartFile : IDisposable
{
    private readonly FileStream file;
    private readonly PngReader reader;

    private PartFile(string path, FileStream file, PngReader reader, PartFacts facts) =>
        (Path, this.file, this.reader, Facts) = (path, file, reader, facts);

    /// <summary>The file, as the caller named it.</summary>
    public string Path { get; }

    /// <summary>Which lines of which picture the file holds.</summary>
    public PartFacts Facts { get; }

    /// <summary>Opens a file.</summary>
    /// <returns>The part, or null for a PNG that is no part.</returns>
    /// <exception cref="PictureFileException">It cannot be read, is no PNG, damaged, or changed by another program.</exception>
    public static PartFile? Open(string path) => PictureFile.Open(path, file =>
    {
        var reader = new PngReader(file, 3 * Camera.MaxPixels);
        if (reader.PartText is not { } text) return null;
        if (PartFacts.Parse(text) is not { } facts)
            throw new PictureFileException("its text about its part of the picture is unknown; perhaps a newer raycaster drew it");
        var header = reader.Header;
        if ((header.Width, header.Height) != (facts.Width, facts.Lines.Count))
            throw new PictureFileException($"it says that it holds the lines {facts.Lines}, each of {facts.Width} pixels, "
                + $"but has {header.Height} lines of {header.Width}: it was changed by another program");
        reader.RequireLines();
        return new PartFile(path, file, reader, facts);
    });

    /// <summary>Whether a file exists, can be read to its last pixel, and holds these lines of this picture.</summary>
    /// <param name="reason">Why not, as the end of a sentence; null if there is no file.</param>
    public static bool Holds(string path, PartFacts facts, out string? reason)
    {
        reason = null;
        if (!File.Exists(path)) return false;
        try
        {
            using var part = Open(path);
            reason = part is null ? "it does not say which scene it shows; only pictures drawn with --rows or --resume do"
                : part.Facts.Version != facts.Version ? $"it was drawn by version {part.Facts.Version}"
                : part.Facts != facts ? "it shows another scene, another size or other lines"
                : null;
            if (reason is not null) return false;
            part!.reader.CheckLines();
            return true;
        }
        catch (PictureFileException e)
        {
            reason = e.Message;
            return false;
        }
    }

    /// <summary>Reads the next line.</summary>
    /// <param name="rgb">Receives three bytes for each pixel.</param>
    /// <exception cref="PictureFileException">The file is damaged.</exception>
    public void ReadLine(Span<byte> rgb)
    {
        try
        {
            reader.ReadLine(rgb);
        }
        catch (PictureFileException e)
        {
            throw new PictureFileException($"cannot read {Path}: {e.Message}", e) { NamesFile = true };
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        reader.Dispose();
        file.Dispose();
    }
}
