namespace RayCaster.Files;

/// <summary>
/// Reads PGM and PPM, in text (P2, P3) and in bytes (P5, P6), with any maxval. Of a pipe or device, reads no further than the first picture:
/// more pictures may follow, without an end.
/// </summary>
internal sealed class PnmReader
{
    /// <summary>The first memory for a picture from a pipe. It grows with the data, because the header may promise too much.</summary>
    private const int FirstBytes = 1 << 16;

    private const int LongestWord = 40;

    private readonly BufferedStream file;
    private readonly byte[] word = new byte[LongestWord];
    private readonly int kind, width, height, maxval;
    private readonly long dataAt; // where the header ends
    private int next; // in the header and in a text: the byte that is looked at; −1 at the end
    private long position; // of that byte, from P; later how many bytes were read
    private int line = 1, wordLength;

    /// <param name="stream">The file after its first byte, which is P.</param>
    public static Picture Read(Stream stream, long maxBytes, Action<string> warn)
    {
        long? length = stream.CanSeek ? stream.Length - stream.Position + 1 : null;
        var reader = new PnmReader(new(stream, 1 << 16), maxBytes);
        var surplus = length - reader.dataAt - reader.DataBytes;
        if (surplus < 0 || (surplus > 0 && reader.kind >= 4)) reader.CheckSurplus(surplus.Value, warn);
        var picture = reader.ReadPixels(length is not null);
        if (length is not null && reader.kind < 4) reader.CheckMoreValues(warn);
        return picture;
    }

    private PnmReader(BufferedStream file, long maxBytes)
    {
        this.file = file;
        Advance();
        var digit = Advance();
        kind = digit - '0';
        if (kind is not (2 or 3 or 5 or 6)) throw OtherKind(digit);
        width = ReadNumber("the width", int.MaxValue);
        height = ReadNumber("the height", int.MaxValue);
        maxval = ReadNumber("maxval", 65535);
        PictureFile.ThrowIfTooLarge(width, height, maxBytes);
        if (kind >= 4) SkipSeparator();
        dataAt = position;
    }

    private int Channels => kind is 3 or 6 ? 3 : 1;

    private long Samples => (long)width * height * Channels;

    /// <summary>The bytes after the header; for a text the fewest possible.</summary>
    private long DataBytes => kind < 4 ? 2 * Samples - 1 // a digit each, and blanks between them
        : maxval > 255 ? 2 * Samples : Samples;

    private Picture ReadPixels(bool isWhole)
    {
        var rgb = new byte[isWhole ? 3L * width * height : Math.Min(FirstBytes, 3L * width * height)];
        var at = 0;
        for (var y = 0; y < height; y++)
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
            for (var x = 0; x < width; x++, at += 3)
            {
                MakeRoom(ref rgb, at + 3);
                for (var c = 0; c < 3; c++) rgb[at + c] = c < Channels ? ReadSample() : rgb[at];
            }
        }
        return new Picture(width, height, rgb);
    }

    private void MakeRoom(ref byte[] rgb, int bytes)
    {
        if (bytes > rgb.Length) Array.Resize(ref rgb, (int)Math.Min(Math.Max(2L * rgb.Length, bytes), 3L * width * height));
    }

    private byte ReadSample()
    {
        var start = position;
        var value = kind < 4 ? ReadNumber(null, maxval) : maxval > 255 ? Byte() << 8 | Byte() : Byte();
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
        if (taken == '\n' || (taken == '\r' && next != '\n')) line++;
        return taken;
    }

    /// <param name="what">Which number of the header it is; null for a sample, which may be 0.</param>
    private int ReadNumber(string? what, int most)
    {
        SkipBlanks(what ?? "a value");
        var number = 0L;
        for (wordLength = 0; next is >= '0' and <= '9' && number <= most;)
        {
            if (wordLength < LongestWord) word[wordLength++] = (byte)next;
            number = number * 10 + Advance() - '0';
        }
        var ends = next < 0 || next == '#' || IsBlank(next);
        return ends && wordLength > 0 && number <= most && number >= (what is null ? 0 : 1) ? (int)number : throw Wrong(ReadWord(), what, most);
    }

    private string ReadWord()
    {
        for (; next >= 0 && !IsBlank(next) && wordLength < LongestWord; Advance()) word[wordLength++] = (byte)next;
        return PictureFile.Printable(word.AsSpan(0, wordLength));
    }

    /// <param name="what">What must follow; null for nothing.</param>
    private void SkipBlanks(string? what = null)
    {
        while (IsBlank(next) || next == '#')
            if (Advance() == '#') SkipComment();
        wordLength = 0;
        if (next < 0 && what is not null) throw new ProblemException($"the file is cut short: it ends where {what} should be");
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
        position++;
    }

    private static bool IsBlank(int value) => value is ' ' or (>= '\t' and <= '\r');

    /// <summary>Says why a file has more or fewer bytes than its header promises. What spoils the pixels is an error.</summary>
    private void CheckSurplus(long surplus, Action<string> warn)
    {
        var there = DataBytes + surplus;
        var from = file.Position;
        var all = there <= 32 * DataBytes + FirstBytes && InputFile.TryReadToEnd(file, Array.MaxLength - 1, out var read) ? read : [];
        file.Position = from;
        var cause = new PnmSurplus(kind, width, height, maxval, endsWithCr: next == '\r').Cause(all, DataBytes, out var isHarmless);
        if (surplus < 0) throw new ProblemException(CutShort(there).Message + (cause is null ? "" : $"; {cause}"));
        var more = $"the file has {Digits.Count(surplus, "byte")} more than its header promises";
        if (cause is not null && !isHarmless) throw new ProblemException($"{more}: {cause}");
        if (cause is not null || !isHarmless) warn($"{more}{(cause is null ? "; they are ignored" : $": {cause}")}");
    }

    /// <summary>Looks for more values in a text. Another picture may follow.</summary>
    private void CheckMoreValues(Action<string> warn)
    {
        var more = 0L;
        for (SkipBlanks(); next >= 0 && next != 'P'; SkipBlanks(), more++)
            while (next >= 0 && !IsBlank(next)) Advance();
        if (more == 0) return;
        var text = $"the file has {Digits.Count(more, "value")} more than its header promises";
        var perPixel = (Samples + more) / ((double)width * height);
        if (kind == 2 && perPixel == 3) throw new ProblemException($"{text}: P2 is grey, one value a pixel; the header for colours is P3");
        if (kind == 3 && perPixel == 4)
            throw new ProblemException($"{text}: it has four values a pixel; a pixel of P3 has red, green and blue, no alpha");
        warn($"{text}; they are ignored");
    }

    private ProblemException OtherKind(int digit)
    {
        var begun = new List<byte> { (byte)'P' };
        for (; digit >= 0 && begun.Count < FileSignature.Bytes; digit = Advance()) begun.Add((byte)digit);
        return new(PictureFile.KindOf([.. begun]));
    }

    private ProblemException CutShort(long there) => new($"the file is cut short: {width:N0} × {height:N0} pixels need "
        + $"{(kind < 4 ? "at least " : "")}{DataBytes:N0} bytes after the header, but there are {there:N0}");

    private ProblemException Wrong(string text, string? what, int most)
    {
        if (what is null && word.AsSpan(0, wordLength).ContainsAnyExceptInRange((byte)' ', (byte)'~'))
            return new($"bytes follow the header, and P{kind} announces a text; the header for bytes is P{kind + 3}");
        var isNumber = double.TryParse(text.Replace(',', '.'), NumberStyles.Float, CultureInfo.InvariantCulture, out var number);
        var cause = text switch
        {
            "-2147483648" or "2147483648" or "-9223372036854775808" => "a NaN that was cast to int becomes this",
            "-858993460" or "3435973836" or "-842150451" => "a variable that was never set has this value",
            _ when text.Contains("nan", StringComparison.OrdinalIgnoreCase) || text.Contains("#IND", StringComparison.OrdinalIgnoreCase) =>
                "not a number: 0 divided by 0, or the root of a negative number",
            _ when text.Contains("inf", StringComparison.OrdinalIgnoreCase) => "something was divided by 0",
            _ when !isNumber => null,
            _ when number != Math.Floor(number) || text.AsSpan().ContainsAny(".,eE") => "round it to a whole number",
            _ => what is null ? "limit colours to 0 … 1 before they become bytes" : null,
        };
        var because = cause is null ? "" : $" ({cause})";
        var message = what is null ? $"'{text}' is no value from 0 to {most}{because}"
            : $"{what} is '{text}', but must be a whole number from 1 to {most}{because}";
        return new(message) { Line = line };
    }
}
