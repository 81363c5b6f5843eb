using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>Divides a text into words without copying them. Blanks separate words; LF, CRLF or CR end a line.</summary>
/// <param name="isObj">Whether, as in OBJ, # starts a comment, and a backslash at the end of a line continues it on the next.</param>
internal sealed class TextScanner(MeshBlock block, bool isObj = false)
{
    private readonly byte[] buffer = block.Buffer;
    private readonly int length = block.Length;
    private int wordEnd;

    /// <summary>Where the search for the next word begins.</summary>
    public int Position { get; set; } = MarkOf(block);

    /// <summary>Where the last word began, or where one was missing.</summary>
    public int WordAt { get; private set; }

    /// <summary>The last word for a message, shortened, without control characters.</summary>
    public string Quoted
    {
        get
        {
            const int most = 40;
            var word = buffer.AsSpan(WordAt, wordEnd - WordAt);
            if (word.IsEmpty) return Position == length ? "the end of the file" : "the end of the line";
            var text = Encoding.UTF8.GetString(word[..Math.Min(word.Length, most)]).Select(c => char.IsControl(c) ? '?' : c);
            return $"'{string.Concat(text)}{(word.Length > most ? "…" : "")}'";
        }
    }

    /// <summary>The next word of this line; empty at the line's end.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public ReadOnlySpan<byte> NextInLine()
    {
        var text = Text;
        var at = SkipBlanks();
        WordAt = at;
        while (at < text.Length && !EndsWord(text[at])) at++;
        // A backslash within a line is a word of its own; otherwise the scanner would not move.
        if (at == WordAt && at < text.Length && text[at] == '\\') at++;
        Position = wordEnd = at;
        return text[WordAt..at];
    }

    /// <summary>The next word, on this line or a later one; empty at the end of the file.</summary>
    public ReadOnlySpan<byte> Next()
    {
        var word = NextInLine();
        while (word.IsEmpty && NextLine()) word = NextInLine();
        return word;
    }

    /// <summary>Skips the rest of the line; false at the end of the file.</summary>
    public bool NextLine()
    {
        while (true)
        {
            var rest = Text[Position..];
            var end = rest.IndexOfAny((byte)'\n', (byte)'\r');
            if (end < 0)
            {
                Position = length;
                return false;
            }
            Position += end + LineEnd(rest[end..]);
            var continues = isObj && end > 0 && rest[end - 1] == '\\' && !rest[..end].Contains((byte)'#');
            if (!continues) return Position < length;
        }
    }

    /// <inheritdoc cref="ToNumber"/>
    public double NextNumber(string what) => ToNumber(NextInLine(), what);

    /// <summary>Reads the word that came last as a number.</summary>
    /// <exception cref="MeshFileException">It is something else, NaN, or beyond the largest number.</exception>
    public double ToNumber(ReadOnlySpan<byte> word, string what)
    {
        if (TryParse(word, out var number)) return number;
        throw Error(word.IsEmpty ? $"{what} is missing" : $"{what} must be a finite number, but is {Quoted}");
    }

    /// <summary>Reads a whole word as the double nearest to it; false where the word is no number or beyond the largest double. Numbers are
    /// as people and programs write them: <c>1</c>, <c>+1.5</c>, <c>.5</c>, <c>5.</c>, <c>-1.5E+3</c>.</summary>
    /// <remarks>Takes half the time of <see cref="double.TryParse(ReadOnlySpan{byte}, out double)"/>, also for the first number.</remarks>
    public static bool TryParse(ReadOnlySpan<byte> word, out double number) =>
        Utf8Parser.TryParse(word, out number, out var length) && length == word.Length && double.IsFinite(number);

    /// <summary>Takes the last line that has an end off a text.</summary>
    /// <param name="line">The line without its end. A line that ends with CR and LF comes as an empty line first.</param>
    public static bool TryTakeLastLine(ref ReadOnlySpan<byte> text, out ReadOnlySpan<byte> line)
    {
        var end = text.LastIndexOfAny((byte)'\n', (byte)'\r');
        line = default;
        if (end < 0) return false;
        text = text[..end];
        line = text[(text.LastIndexOfAny((byte)'\n', (byte)'\r') + 1)..];
        return true;
    }

    public MeshFileException Error(string reason) => ErrorAt(WordAt, reason);

    public MeshFileException ErrorAt(int position, string reason) => block.Source.ErrorAtLine(block.Start + position, reason);

    /// <summary>The bytes of the byte order mark that some editors write at the beginning of a file.</summary>
    /// <exception cref="MeshFileException">The text is in UTF-16.</exception>
    private static int MarkOf(MeshBlock block) => (block.Start == 0 ? block.Bytes : []) switch
    {
        [0xEF, 0xBB, 0xBF, ..] => 3,
        [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..] => throw block.Source.ErrorAtLine(0, "the file is in UTF-16; save it as UTF-8"),
        _ => 0,
    };

    private ReadOnlySpan<byte> Text => buffer.AsSpan(0, length);

    private int SkipBlanks()
    {
        var text = Text;
        var at = Position;
        while (at < text.Length)
        {
            if (text[at] is (byte)' ' or (byte)'\t' or (byte)'\v' or (byte)'\f')
                at++;
            else if (isObj && text[at] == '\\' && LineEnd(text[(at + 1)..]) is > 0 and var lineEnd)
                at += 1 + lineEnd;
            else if (isObj && text[at] == '#')
                return text[at..].IndexOfAny((byte)'\n', (byte)'\r') is >= 0 and var end ? at + end : text.Length;
            else
                break;
        }
        return at;
    }

    private bool EndsWord(byte c) =>
        c is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r') || (isObj && c is (byte)'#' or (byte)'\\');

    /// <summary>The bytes of the line end at the beginning of a text; 0 for none.</summary>
    private static int LineEnd(ReadOnlySpan<byte> text) => text switch
    {
        [(byte)'\r', (byte)'\n', ..] => 2,
        [(byte)'\r' or (byte)'\n', ..] => 1,
        _ => 0,
    };
}
