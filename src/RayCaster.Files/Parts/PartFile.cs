namespace RayCaster.Files;

/// <summary>A PNG that holds some lines of a picture, and says so; its lines are read one by one.</summary>
public sealed class PartFile : IDisposable
{
    private readonly FileStream file;
    private readonly PngReader reader;

    private PartFile(string path, FileStream file, PngReader reader, PartFacts facts) =>
        (Path, this.file, this.reader, Facts) = (path, file, reader, facts);

    /// <summary>The file, as the caller named it.</summary>
    public string Path { get; }

    /// <summary>What the file says of itself.</summary>
    public PartFacts Facts { get; }

    /// <summary>Opens a file.</summary>
    /// <returns>The part, or null if the file is a PNG that says nothing of parts.</returns>
    /// <exception cref="PictureFileException">It cannot be read, is no PNG, damaged, or not what it says.</exception>
    public static PartFile? Open(string path) => PictureFile.Open(path, file =>
    {
        if (!file.CanSeek) throw new PictureFileException("it is a pipe or a device; a part is a file");
        if (file.ReadByte() is var first && first != PngChunk.Signature[0])
            throw new PictureFileException(first < 0 ? "the file is empty" : "it is no PNG, and so no part of a picture");
        var reader = new PngReader(file, 3 * Camera.MaxPixels);
        if (reader.PartText is not { } text) return null;
        if (PartFacts.Parse(text) is not { } facts)
            throw new PictureFileException("what it says about its part of the picture cannot be understood; a newer raycaster may have drawn it");
        var header = reader.Header;
        if ((header.Width, header.Height) != (facts.Width, facts.Lines.Count))
            throw new PictureFileException($"it says that it holds the lines {facts.Lines}, each of {facts.Width} pixels, "
                + $"but has {header.Height} lines of {header.Width}: it was changed by another program");
        if (header.Interlaced) throw new PictureFileException("it is interlaced, so that its lines cannot be read one after another");
        return new PartFile(path, file, reader, facts);
    });

    /// <summary>Whether a file is there, is not damaged, and holds just this. Its pixels are not decompressed, but their checksums are checked.</summary>
    public static bool Holds(string path, PartFacts facts)
    {
        if (!File.Exists(path)) return false;
        try
        {
            using var part = Open(path);
            if (part?.Facts != facts) return false;
            part.reader.CheckData();
            return true;
        }
        catch (PictureFileException)
        {
            return false; // a damaged part is drawn anew
        }
    }

    /// <summary>Reads the next line.</summary>
    /// <param name="rgb">Takes three bytes a pixel.</param>
    /// <exception cref="PictureFileException">The file is damaged.</exception>
    public void ReadLine(Span<byte> rgb)
    {
        try
        {
            reader.ReadLine(rgb);
        }
        catch (PictureFileException e)
        {
            throw new PictureFileException($"cannot read {Path}: {e.Message}", e);
        }
    }

    /// <summary>Closes the file.</summary>
    public void Dispose()
    {
        reader.Dispose();
        file.Dispose();
    }
}
