namespace RayCaster.Files;

/// <summary>
/// Writes a picture line by line from the top, in memory that does not grow with the number of lines. Exceptions of the output stream are not
/// changed.
/// </summary>
public abstract class PictureWriter : IDisposable
{
    private int linesMissing;
    private bool finished;

    private protected PictureWriter(Stream output, int width, int height)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        Output = output;
        LineBytes = checked(width * 3);
        linesMissing = height;
    }

    private protected Stream Output { get; }

    private protected int LineBytes { get; }

    /// <summary>Begins a picture: writes the header.</summary>
    /// <param name="output">Receives the file's bytes in order. It need not seek, and is left open.</param>
    /// <param name="text">A text that the file holds beside the picture, in Latin-1; only a PNG can.</param>
    public static PictureWriter Create(
        PictureFormat format, Stream output, int width, int height, (string Keyword, string Value)? text = null) => format switch
        {
            PictureFormat.Png => new PngWriter(output, width, height, text),
            _ when text is not null => throw new ArgumentException("only a PNG can hold a text", nameof(format)),
            PictureFormat.Ppm or PictureFormat.PpmText => new PpmWriter(output, width, height, isText: format == PictureFormat.PpmText),
            _ => throw new ArgumentOutOfRangeException(nameof(format), format, null),
        };

    /// <summary>Writes the next lines.</summary>
    /// <param name="rgb">Any number of whole lines, width · 3 bytes each: red, green, blue, from left to right.</param>
    /// <exception cref="ArgumentException">The last line is not whole.</exception>
    /// <exception cref="InvalidOperationException">The picture has fewer lines.</exception>
    public void WriteRows(ReadOnlySpan<byte> rgb)
    {
        var (lines, rest) = Math.DivRem(rgb.Length, LineBytes);
        if (rest != 0) throw new ArgumentException($"{rgb.Length} bytes are not whole lines of {LineBytes}", nameof(rgb));
        if (lines > linesMissing) throw new InvalidOperationException($"{lines} lines for a picture that misses only {linesMissing}");
        linesMissing -= lines;
        Encode(rgb);
    }

    /// <summary>Ends the file and flushes the output.</summary>
    /// <exception cref="InvalidOperationException">Lines are missing, or the file was ended before.</exception>
    public void Finish()
    {
        if (linesMissing > 0) throw new InvalidOperationException($"the picture misses {linesMissing} lines");
        if (finished) throw new InvalidOperationException("the picture is finished");
        finished = true;
        EncodeEnd();
        Output.Flush();
    }

    /// <summary>Frees the writer's memory. It does not end the file: a picture that was not finished is visibly cut.</summary>
    public virtual void Dispose() => GC.SuppressFinalize(this);

    private protected abstract void Encode(ReadOnlySpan<byte> lines);

    private protected virtual void EncodeEnd()
    {
    }
}
