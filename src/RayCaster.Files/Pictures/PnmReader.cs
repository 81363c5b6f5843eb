namespace RayCaster.Files;

/// <summary>
/// Reads PBM, PGM and PPM, in text (P1, P2, P3) and in bytes (P4, P5, P6), with any maxval. Reads no further than the first picture of a file:
/// more pictures may follow, without an end.
/// </summary>
internal sealed class PnmReader
{
    /// <summary>The first memory for a picture from a pipe. It grows with the data, because the header may promise too much.</summary>
    private const int FirstBytes = 1 << 16;

    private readonly BufferedStream file;
    private readonly int kind, width, height, maxval;
    private readonly long dataAt; // where the header ends
    private int next; // in the header and in a text: the byte that is looked at; −1 at the end
    private long position; // of that byte; later how many bytes were read

    /// <param name="file">The file after its first byte, which is P.</param>
    /// <param name="length">The bytes of the file with that byte; null for a pipe or device.</param>
    public static Picture Read(BufferedStream file, long? length, long maxBytes) => new PnmReader(file, maxBytes).ReadPixels(length);

    private PnmReader(BufferedStream file, long maxBytes)
    {
        this.file = file;
        Advance();
        var digit = Advance();
        kind = digit - '0';
        if (kind is < 1 or > 6)
            throw new ProblemException(
                $"it begins with 'P{PictureFile.Printable(digit < 0 ? [] : [(byte)digit])}'; P1 to P6 can be read, and PNG");
        width = ReadNumber("the width");
        height = ReadNumber("the height");
        maxval = kind is 1 or 4 ? 1 : ReadNumber("maxval");
        if (maxval is < 1 or > 65535) throw new ProblemException($"maxval is {maxval}, but must be from 1 to 65535");
        PictureFile.CheckSize(width, height, maxBytes);
        if (kind >= 4) SkipSeparator();
        dataAt = position;
    }

    private int Channels => kind is 3 or 6 ? 3 : 1;

    private long Samples => (long)width * height * Channels;

    /// <summary>The bytes after the header; for a text the fewest possible.</summary>
    private long DataBytes => kind switch
    {
        1 => Samples, // digits need no blanks between them
        2 or 3 => 2 * Samples - 1, // a digit each, and blanks between them
        4 => (width + 7L) / 8 * height,
        _ => maxval > 255 ? 2 * Samples : Samples,
    };

    private Picture ReadPixels(long? length)
    {
        if (length is { } bytes && bytes - dataAt < DataBytes) throw CutShort(bytes - dataAt);
        var rgb = new byte[length is null ? Math.Min(FirstBytes, 3L * width * height) : 3L * width * height];
        for (var (y, at) = (0, 0); y < height; y++)
        {
            if (kind == 6 && maxval == 255)
            {
                for (var end = at + 3 * width; at < end;)
                {
                    MakeRoom(ref rgb, at + 1);
                    var count = file.Read(rgb.AsSpan(at, Math.Min(rgb.Length, end) - at));
                    if (count == 0) throw CutShort(at);
                    at += count;
                }
                continue;
            }
            var bits = 0;
            for (var x = 0; x < width; x++, at += 3)
            {
                MakeRoom(ref rgb, at + 3);
                if (kind == 4) bits = x % 8 == 0 ? Byte() : bits << 1;
                for (var c = 0; c < 3; c++) rgb[at + c] = c < Channels ? ReadSample(bits) : rgb[at];
            }
        }
        return new Picture(width, height, rgb);
    }

    /// <summary>Doubles the picture's memory when it is full, up to what the header says.</summary>
    private void MakeRoom(ref byte[] rgb, int bytes)
    {
        if (bytes > rgb.Length) Array.Resize(ref rgb, (int)Math.Min(Math.Max(2L * rgb.Length, bytes), 3L * width * height));
    }

    /// <summary>The next sample, scaled to 8 bits and rounded to nearest.</summary>
    /// <param name="bits">For P4: the sample is the highest of these eight bits.</param>
    private byte ReadSample(int bits)
    {
        var start = position;
        var value = kind switch
        {
            1 => 1 - ReadBit(), // in a bitmap 1 is ink: black
            2 or 3 => ReadNumber("a value"),
            4 => 1 - (bits >> 7 & 1),
            _ when maxval > 255 => Byte() << 8 | Byte(),
            _ => Byte(),
        };
        if (value > maxval) throw new ProblemException($"the value {value} at byte {start} is greater than maxval, which is {maxval}");
        return (byte)((value * 255 + maxval / 2) / maxval);
    }

    private int Byte()
    {
        var value = file.ReadByte();
        if (value < 0) throw CutShort(position - dataAt);
        position++;
        return value;
    }

    /// <summary>Takes the byte that is looked at, and looks at the one after it.</summary>
    private int Advance()
    {
        var taken = next;
        next = file.ReadByte();
        position++;
        return taken;
    }

    private int ReadBit()
    {
        SkipBlanks("a 0 or 1");
        return next is '0' or '1' ? Advance() - '0' : throw Unexpected("a 0 or 1");
    }

    private int ReadNumber(string what)
    {
        SkipBlanks(what);
        if (!IsDigit(next)) throw Unexpected(what);
        var (number, start) = (0L, position);
        while (IsDigit(next))
        {
            number = number * 10 + Advance() - '0';
            if (number > int.MaxValue)
                throw new ProblemException($"{what} at byte {start} is greater than {int.MaxValue:N0}, which is the limit");
        }
        return (int)number;
    }

    /// <summary>Skips blanks and comments. The file must go on after them.</summary>
    private void SkipBlanks(string what)
    {
        while (IsBlank(next) || next == '#')
            if (Advance() == '#') SkipComment();
        if (next < 0) throw new ProblemException($"the file is cut short: it ends where {what} should be");
    }

    /// <summary>Skips from # to the end of the line; the line end is left.</summary>
    private void SkipComment()
    {
        while (next is >= 0 and not ('\n' or '\r')) Advance();
    }

    /// <summary>Skips the one blank, or the comment with its line end, before the bytes. No more: the first bytes may look like blanks.</summary>
    private void SkipSeparator()
    {
        if (next == '#') SkipComment();
        if (next < 0) throw new ProblemException("the file is cut short: it ends with its header");
        if (!IsBlank(next)) throw Unexpected("a line end");
        position++;
    }

    private static bool IsBlank(int value) => value is ' ' or (>= '\t' and <= '\r');

    private static bool IsDigit(int value) => value is >= '0' and <= '9';

    /// <summary>The error for a header that promises more than the file holds.</summary>
    private ProblemException CutShort(long there) => new($"the file is cut short: {width:N0} × {height:N0} pixels need "
        + $"{(kind < 4 ? "at least " : "")}{DataBytes:N0} bytes after the header, but there are {there:N0}");

    private ProblemException Unexpected(string due) =>
        new($"'{PictureFile.Printable([(byte)next])}' at byte {position}, where {due} should be");
}
