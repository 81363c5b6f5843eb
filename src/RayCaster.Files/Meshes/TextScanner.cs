using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>Divides a text into lines and words without copying them. Blanks separate words; LF, CRLF or CR end a line.</summary>
internal sealed class TextScanner
{
    public const int LongestQuote = 40;

    private readonly MeshSource source;
    private readonly bool isObj;
    private int length, lineEnd; // the bytes of the line without its end, and of its end
    private int lineNumber = 1, joinedLines; // continuation lines that a backslash joins to this one
    private int wordAt;

    /// <param name="isObj">Whether, as in OBJ, # starts a comment, and a backslash at the end of a vertex or face continues it on the next
    /// line. Other lines may end with a name that ends so: <c>g C:\parts\</c>.</param>
    public TextScanner(MeshSource source, bool isObj = false)
    {
        (this.source, this.isObj) = (source, isObj);
        source.Has(3);
        if (source.Bytes is [0xEF, 0xBB, 0xBF, ..]) source.Skip(3); // the byte order mark that some editors write
        LoadLine();
    }

    /// <summary>Where the search for the next word begins: the last word's end.</summary>
    public int Position { get; private set; }

    public ReadOnlySpan<byte> LineEnd => source.Bytes.Slice(length, lineEnd);

    /// <summary>The line of the last word, or where one was missing.</summary>
    public int LineNumber => lineNumber + (joinedLines > 0 ? CountLines(Line[..wordAt]) : 0);

    public string Quoted
    {
        get
        {
            var word = Line[wordAt..Math.Max(wordAt, Position)]; // Return may have gone back before it
            if (word.IsEmpty) return lineEnd == 0 ? "the end of the file" : "the end of the line";
            return $"'{PrintableText.From(Beginning(word))}{(word.Length > LongestQuote ? "…" : "")}'";
        }
    }

    /// <summary>The next word of this line; empty at the line's end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public ReadOnlySpan<byte> NextInLine()
    {
        var text = Line;
        var at = SkipBlanks(text);
        wordAt = at;
        while (at < text.Length && (!EndsWord(text[at]) || IsNotFinite(text, at))) at++;
        // A backslash within a line is a word of its own; otherwise the scanner would not move.
        if (at == wordAt && at < text.Length && text[at] == '\\') at++;
        Position = at;
        return text[wordAt..at];
    }

    /// <summary>The next word, on this line or a later one; empty at the end of the file.</summary>
    public ReadOnlySpan<byte> Next()
    {
        var word = NextInLine();
        while (word.IsEmpty && NextLine()) word = NextInLine();
        return word;
    }

    /// <summary>Goes back to the beginning of the last word, or to a <see cref="Position"/> in the line.</summary>
    public void Return(int? position = null) => Position = position ?? wordAt;

    /// <summary>Skips the rest of the line; false at the end of the file.</summary>
    public bool NextLine()
    {
        var next = lineNumber + 1 + joinedLines;
        source.Skip(length + lineEnd);
        (Position, wordAt) = (0, 0);
        if (!LoadLine()) return false;
        lineNumber = next;
        return true;
    }

    /// <summary>Ends the text with this line: other bytes follow.</summary>
    public void EndText(int lineEndBytes) => source.Skip(length + lineEndBytes);

    public double NextNumber(string what) => ToNumber(NextInLine(), what);

    public double ToNumber(ReadOnlySpan<byte> word, string what)
    {
        if (TryParse(word, out var number)) return number;
        throw Error(word.IsEmpty ? $"{what} is missing"
            : $"{what} must be a finite number, but is {Quoted}{NumberSpelling.Hint(Beginning(word))}");
    }

    /// <summary>Reads a whole word as the double nearest to it; false where the word is no number or beyond the largest double. Numbers are
    /// as people and programs write them: <c>1</c>, <c>+1.5</c>, <c>.5</c>, <c>5.</c>, <c>-1.5E+3</c>.</summary>
    /// <remarks>Takes half the time of <see cref="double.TryParse(ReadOnlySpan{byte}, out double)"/>, also for the first number.</remarks>
    public static bool TryParse(ReadOnlySpan<byte> word, out double number) =>
        IsNumber(word, out number) && double.IsFinite(number);

    /// <summary>The same for a number that may be beyond the largest double: then it is infinite.</summary>
    public static bool IsNumber(ReadOnlySpan<byte> word, out double number) =>
        Utf8Parser.TryParse(word, out number, out var length) && length == word.Length;

    public ProblemException Error(string reason) => source.ErrorAtLine(LineNumber, reason);

    private static string Beginning(ReadOnlySpan<byte> word) => Encoding.UTF8.GetString(word[..Math.Min(word.Length, LongestQuote)]);

    private ReadOnlySpan<byte> Line => source.Bytes[..length];

    /// <summary>Finds the end of the line that begins here, and loads it as a whole; false at the end of the file.</summary>
    private bool LoadLine()
    {
        var begin = 0; // of the last line that a backslash continues
        var searched = 0; // no line end is before this place
        for (joinedLines = 0; ; joinedLines++, begin = searched = length + lineEnd)
        {
            while ((length = EndIn(source.Bytes, searched)) < 0)
            {
                searched = source.Bytes is [.., (byte)'\r'] ? source.Bytes.Length - 1 : source.Bytes.Length;
                if (source.Load()) continue;
                length = searched;
                break;
            }
            var text = source.Bytes;
            lineEnd = LineEndOf(text[length..]);
            var continues = isObj && lineEnd > 0 && length > begin && text[length - 1] == '\\' && !text[begin..length].Contains((byte)'#')
                && text[..length].TrimStart(" \t"u8) is [(byte)'v' or (byte)'f', (byte)' ' or (byte)'\t' or (byte)'\\', ..];
            if (!continues) return length + lineEnd > 0;
        }

        // Where the line end is; −1 if there is none, or an LF may follow a CR.
        static int EndIn(ReadOnlySpan<byte> text, int from)
        {
            var end = text[from..].IndexOfAny((byte)'\n', (byte)'\r');
            return end < 0 || text[(from + end)..] is [(byte)'\r'] ? -1 : from + end;
        }
    }

    private int SkipBlanks(ReadOnlySpan<byte> text)
    {
        var at = Position;
        while (at < text.Length)
        {
            if (text[at] is (byte)' ' or (byte)'\t' or (byte)'\v' or (byte)'\f')
                at++;
            else if (isObj && text[at] == '\\' && LineEndOf(text[(at + 1)..]) is > 0 and var end)
                at += 1 + end;
            else if (isObj && text[at] == '#')
                return text.Length;
            else
                break;
        }
        return at;
    }

    private bool EndsWord(byte c) =>
        c is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r') || (isObj && c is (byte)'#' or (byte)'\\');

    // Where older C libraries of Windows have written NaN or infinity: 1.#INF, -1.#IND. The # starts no comment there.
    private static bool IsNotFinite(ReadOnlySpan<byte> text, int at) =>
        text[at] == '#' && at >= 2 && text[(at - 2)..at].SequenceEqual("1."u8) && text.Length > at + 1 && "IQSJR"u8.Contains(text[at + 1]);

    private static int CountLines(ReadOnlySpan<byte> text) => text.Count((byte)'\n') + text.Count((byte)'\r') - text.Count("\r\n"u8);

    private static int LineEndOf(ReadOnlySpan<byte> text) => text switch
    {
        [(byte)'\r', (byte)'\n', ..] => 2,
        [(byte)'\r' or (byte)'\n', ..] => 1,
        _ => 0,
    };
}
