namespace RayCaster.Files;

/// <summary>Reads and writes whole pictures.</summary>
public static class PictureFile
{
    /// <summary>The largest array there is, a little less than 2^31 bytes.</summary>
    internal static long MaxBytes => Array.MaxLength;

    internal const string InUtf16 =
        "the file is in UTF-16, as PowerShell's > writes it: let the program write the file itself, or redirect in cmd";

    /// <summary>
    /// Reads a PNG (every colour type, bit depth and interlacing) or a PGM or PPM (P2, P3, P5, P6), recognised by its first bytes.
    /// Samples are scaled to 8 bits, rounded to nearest. Nothing else is done to them: gamma and colour profiles are not applied, and
    /// alpha is dropped, so that a transparent pixel shows the colour that is stored in it.
    /// </summary>
    /// <param name="warn">Gets what is odd about a file that is read all the same, in a line that names the file.</param>
    /// <exception cref="ProblemException">The file cannot be read, is damaged, of another kind, or too large.</exception>
    public static Picture Read(string path, Action<string>? warn = null) =>
        Open(path, file => Read(file, MaxBytes, odd => warn?.Invoke($"{path}: warning: {odd}")));

    /// <summary>Reads a picture from the rest of a stream, as <see cref="Read(string, Action{string})"/> does; the messages name no file.</summary>
    /// <exception cref="ProblemException">The data are damaged, of another kind, or too large.</exception>
    /// <exception cref="IOException">The stream fails.</exception>
    /// <param name="limit">The most bytes that the picture may take in memory, three for each pixel; those of the largest array if left out.</param>
    public static Picture Read(Stream stream, long? limit = null)
    {
        try
        {
            return Read(stream, limit ?? MaxBytes, _ => { });
        }
        catch (ProblemException e) when (e.Line > 0)
        {
            throw new ProblemException($"line {e.Line}: {e.Message}", e);
        }
    }

    private static Picture Read(Stream stream, long maxBytes, Action<string> warn)
    {
        try
        {
            var first = stream.ReadByte(); // shows the format; a pipe cannot seek back
            if (first < 0) throw new ProblemException("the file is empty");
            if (first == PngChunk.Signature[0]) return PngReader.Read(InMemory((byte)first, stream), maxBytes, warn);
            if (first == 'P') return PnmReader.Read(stream, maxBytes, warn);
            var begun = new byte[FileSignature.Bytes];
            begun[0] = (byte)first;
            var count = 1 + stream.ReadAtLeast(begun.AsSpan(1, 3), 3, throwOnEndOfStream: false);
            if (begun.AsSpan(0, count) is [0xEF, 0xBB, 0xBF, (byte)'P']) return PnmReader.Read(stream, maxBytes, warn); // after a byte order mark
            count += stream.ReadAtLeast(begun.AsSpan(count), begun.Length - count, throwOnEndOfStream: false);
            throw new ProblemException(KindOf(begun.AsSpan(0, count)));
        }
        catch (OutOfMemoryException e)
        {
            throw new ProblemException("there is not enough memory for the picture", e);
        }
    }

    /// <summary>Writes a picture in the format of the path's extension. An old file is replaced at the end, and stays if anything fails.</summary>
    /// <exception cref="ProblemException">The extension names no format, or the file cannot be written.</exception>
    public static void Write(string path, Picture picture)
    {
        var format = FormatOf(path);
        AtomicFile.Write(path, file => Write(file, picture, format));
    }

    internal static PictureFormat FormatOf(string path) => Path.GetExtension(path).ToLowerInvariant() switch
    {
        ".png" => PictureFormat.Png,
        ".ppm" => PictureFormat.Ppm,
        "" => throw new ProblemException($"no picture format for '{path}': the name has no extension; use .png or .ppm"),
        var other => throw new ProblemException($"no picture format for '{path}': {other} is not known; use .png or .ppm"),
    };

    /// <summary>Writes a picture to a stream, which is left open.</summary>
    public static void Write(Stream output, Picture picture, PictureFormat format)
    {
        using var writer = PictureWriter.Create(format, output, picture.Width, picture.Height);
        writer.WriteRows(picture.Rgb);
        writer.Finish();
    }

    /// <summary>Opens a file, reads it and closes it; errors name the file.</summary>
    internal static T Open<T>(string path, Func<FileStream, T> read)
    {
        try
        {
            using var file = InputFile.Open(path, "picture");
            return read(file);
        }
        catch (ProblemException e) when (e.InnerException is FileNotFoundException or DirectoryNotFoundException)
        {
            throw new ProblemException($"picture file not found: {path}\n  looked for {PrintableText.From(Path.GetFullPath(path))}", e);
        }
        catch (Exception e) when (e is IOException or ProblemException { NamesFile: false })
        {
            var line = e is ProblemException { Line: > 0 and var at } ? $"({at})" : "";
            throw new ProblemException($"cannot read {path}{line}: {(e is IOException ? ProblemException.Reason(e) : e.Message)}", e)
            { NamesFile = true };
        }
    }

    /// <summary>Refuses a picture that does not fit into memory as a whole, before anything is allocated for it.</summary>
    /// <param name="maxBytes">The most bytes that it may take, three for each pixel; those of the largest array if left out.</param>
    internal static void ThrowIfTooLarge(long width, long height, long? maxBytes = null)
    {
        if (width < 1 || height < 1)
            throw new ProblemException($"its size is {width} × {height} pixels, but each side must be at least 1");
        var bytes = (Int128)width * height * 3;
        if (bytes > (maxBytes ?? MaxBytes))
            throw new ProblemException(
                $"a picture of {width:N0} × {height:N0} pixels needs {bytes:N0} bytes, the limit is {maxBytes ?? MaxBytes:N0}");
    }

    /// <summary>A piece of a damaged file, fit for a message.</summary>
    internal static string Printable(ReadOnlySpan<byte> bytes) =>
        string.Concat(bytes.ToArray().Select(value => value is >= 0x20 and < 0x7F ? $"{(char)value}" : $"\\x{value:X2}"));

    private static MemoryStream InMemory(byte first, Stream rest)
    {
        var bytes = InputFile.ReadToEnd(rest, "file", Array.MaxLength - 1, begun: [first]);
        return new(bytes.Array!, bytes.Offset, bytes.Count);
    }

    internal static string KindOf(ReadOnlySpan<byte> file)
    {
        if (FileSignature.IsUtf16(file)) return InUtf16;
        var text = file.TrimStart(" \t\r\n"u8);
        if (text is [(byte)'P' or (byte)'p', (byte)'2' or (byte)'3' or (byte)'5' or (byte)'6', ..])
            return $"nothing may stand before P{(char)text[1]}, which is a capital letter";
        var kind = FileSignature.Recognize(file) is { } known ? $"it is {known}"
            : $"it begins with '{Printable(file[..Math.Min(file.Length, 8)])}', which is no known picture format";
        return kind + "; PNG, PGM and PPM can be read";
    }
}
