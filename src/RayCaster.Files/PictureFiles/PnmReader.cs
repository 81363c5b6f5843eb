namespace RayCaster.Files;

/// <summary>
/// PBM, PGM and PPM, in text (P1, P2, P3) and in bytes (P4, P5, P6), with any maxval. Of several pictures in a file the first is read.
/// </summary>
internal ref struct PnmReader
{
    private readonly ReadOnlySpan<byte> file;
    private readonly int kind, width, height, maxval;
    private int at = 2; // after the P and its digit

    /// <exception cref="PictureFileException">The file is damaged or too large.</exception>
    public static Picture Read(ReadOnlySpan<byte> file, long mostBytes)
    {
        var reader = new PnmReader(file, mostBytes);
        reader.CheckLength();
        return reader.ReadPixels();
    }

    private PnmReader(ReadOnlySpan<byte> file, long mostBytes)
    {
        this.file = file;
        kind = file.Length < 2 ? 0 : file[1] - '0';
        if (kind is < 1 or > 6)
        {
            var start = PictureFile.Printable(file[..Math.Min(2, file.Length)]);
            throw new PictureFileException($"it begins with '{start}'; P1 to P6 can be read, and PNG");
        }
        width = ReadNumber("the width");
        height = ReadNumber("the height");
        maxval = kind is 1 or 4 ? 1 : ReadNumber("maxval");
        if (maxval is < 1 or > 65535) throw new PictureFileException($"maxval is {maxval}, but must be from 1 to 65535");
        PictureFile.CheckSize(width, height, mostBytes);
        if (kind >= 4) SkipSeparator();
    }

    private readonly int Channels => kind is 3 or 6 ? 3 : 1;

    /// <summary>Refuses a header that promises more than the file holds, before anything is allocated for it.</summary>
    private readonly void CheckLength()
    {
        var samples = (long)width * height * Channels;
        var (bytes, least) = kind switch
        {
            1 => (samples, "at least "), // digits may stand close together
            2 or 3 => (2 * samples - 1, "at least "), // a digit each, and blanks between them
            4 => ((width + 7L) / 8 * height, ""),
            _ => (maxval > 255 ? 2 * samples : samples, ""),
        };
        if (file.Length - at >= bytes) return;
        throw new PictureFileException($"the file is cut short: {width:N0} × {height:N0} pixels need {least}{bytes:N0} bytes "
            + $"after the header, but there are {file.Length - at:N0}");
    }

    private Picture ReadPixels()
    {
        var picture = new Picture(width, height);
        var rgb = picture.Rgb.AsSpan();
        if (kind == 6 && maxval == 255)
        {
            file.Slice(at, rgb.Length).CopyTo(rgb);
            return picture;
        }
        for (var y = 0; y < height; y++)
        {
            for (var x = 0; x < width; x++, rgb = rgb[3..])
            {
                if (Channels == 1) rgb[..3].Fill(ReadSample(x));
                else (rgb[0], rgb[1], rgb[2]) = (ReadSample(x), ReadSample(x), ReadSample(x));
            }
            if (kind == 4) at += (width + 7) / 8;
        }
        return picture;
    }

    /// <summary>The next sample, scaled to 8 bits and rounded to nearest.</summary>
    private byte ReadSample(int x)
    {
        var start = at;
        var value = kind switch
        {
            1 => 1 - ReadBit(), // in a bitmap 1 is ink: black
            2 or 3 => ReadNumber("a value"),
            4 => 1 - (file[at + x / 8] >> (7 - x % 8) & 1),
            _ when maxval > 255 => file[at++] << 8 | file[at++],
            _ => file[at++],
        };
        if (value > maxval) throw new PictureFileException($"the value {value} at byte {start} is greater than maxval, which is {maxval}");
        return (byte)((value * 255 + maxval / 2) / maxval);
    }

    private int ReadBit()
    {
        SkipBlanks("a 0 or 1");
        return file[at] is (byte)'0' or (byte)'1' ? file[at++] - '0' : throw Unexpected("a 0 or 1");
    }

    /// <summary>A whole number after any blanks and comments.</summary>
    private int ReadNumber(string what)
    {
        SkipBlanks(what);
        if (!char.IsAsciiDigit((char)file[at])) throw Unexpected(what);
        var (number, start) = (0L, at);
        for (; at < file.Length && char.IsAsciiDigit((char)file[at]); at++)
        {
            number = number * 10 + file[at] - '0';
            if (number > int.MaxValue)
                throw new PictureFileException($"{what} at byte {start} is greater than {int.MaxValue:N0}, which is the limit");
        }
        return (int)number;
    }

    /// <summary>Skips to the next thing that is neither blank nor comment; it is there.</summary>
    private void SkipBlanks(string what)
    {
        for (; at < file.Length && (IsBlank(file[at]) || file[at] == '#'); at++)
            if (file[at] == '#') SkipComment();
        if (at >= file.Length) throw new PictureFileException($"the file is cut short: it ends where {what} is due");
    }

    /// <summary>From # to the end of the line, or to the last byte of the file.</summary>
    private void SkipComment()
    {
        while (at < file.Length - 1 && file[at] is not ((byte)'\n' or (byte)'\r')) at++;
    }

    /// <summary>Exactly one blank, or a comment with its line end, stands before the bytes, which may look like blanks too.</summary>
    private void SkipSeparator()
    {
        if (at < file.Length && file[at] == '#') SkipComment();
        if (at >= file.Length) throw new PictureFileException("the file is cut short: it ends with its header");
        if (!IsBlank(file[at])) throw Unexpected("a line end");
        at++;
    }

    private static bool IsBlank(byte value) => value is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r');

    private readonly PictureFileException Unexpected(string due) =>
        new($"'{PictureFile.Printable(file.Slice(at, 1))}' at byte {at}, where {due} is due");
}
