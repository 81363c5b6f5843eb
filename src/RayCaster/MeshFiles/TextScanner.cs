using System.Text;

namespace RayCaster;

/// <summary>Cuts a text into words where they stand, without copying them. Words are separated by blanks, lines end with LF, CRLF or CR.</summary>
/// <param name="source">The file.</param>
/// <param name="position">Where the text begins.</param>
/// <param name="isObj">Whether, as in OBJ, # starts a comment and a backslash at the end of a line continues it on the next.</param>
internal sealed class TextScanner(MeshSource source, int position, bool isObj = false)
{
    private readonly byte[] text = source.Bytes;
    private int wordEnd;

    /// <summary>Starts at the beginning of a file, past the byte order mark that some editors leave there.</summary>
    /// <exception cref="MeshFileException">The text is in UTF-16.</exception>
    public static TextScanner OfFile(MeshSource source, bool isObj = false) => source.Bytes switch
    {
        [0xEF, 0xBB, 0xBF, ..] => new(source, 3, isObj),
        [0xFF, 0xFE, ..] or [0xFE, 0xFF, ..] => throw source.ErrorAtLine(0, "the file is in UTF-16; save it as UTF-8"),
        _ => new(source, 0, isObj),
    };

    /// <summary>Where the next word is looked for.</summary>
    public int Position { get; set; } = position;

    /// <summary>Where the last word began, or where one was missing.</summary>
    public int WordAt { get; private set; }

    /// <summary>The last word for a message: short and printable, whatever it is.</summary>
    public string Quoted
    {
        get
        {
            const int most = 40;
            var word = text.AsSpan(WordAt, wordEnd - WordAt);
            if (word.IsEmpty) return Position == text.Length ? "the end of the file" : "the end of the line";
            var quoted = new StringBuilder("'");
            foreach (var c in Encoding.UTF8.GetString(word[..Math.Min(word.Length, most)])) quoted.Append(char.IsControl(c) ? '?' : c);
            return quoted.Append(word.Length > most ? "…'" : "'").ToString();
        }
    }

    /// <summary>The next word of this line; empty at the line's end.</summary>
    public ReadOnlySpan<byte> NextInLine()
    {
        var at = SkipBlanks();
        WordAt = at;
        while (at < text.Length && !EndsWord(text[at])) at++;
        // A backslash that continues nothing is a word of its own, or the scanner would not move.
        if (at == WordAt && at < text.Length && text[at] == '\\') at++;
        Position = wordEnd = at;
        return text.AsSpan(WordAt, at - WordAt);
    }

    /// <summary>The next word, on this line or a later one; empty at the end of the file.</summary>
    public ReadOnlySpan<byte> Next()
    {
        while (true)
        {
            var word = NextInLine();
            if (!word.IsEmpty || !NextLine()) return word;
        }
    }

    /// <summary>Leaves the rest of the line and goes to the next; false where there is none.</summary>
    public bool NextLine()
    {
        while (true)
        {
            var rest = text.AsSpan(Position);
            var length = rest.IndexOfAny((byte)'\n', (byte)'\r');
            if (length < 0)
            {
                Position = text.Length;
                return false;
            }
            Position += length + LineEnd(rest[length..]);
            var continues = isObj && length > 0 && rest[length - 1] == '\\' && !rest[..length].Contains((byte)'#');
            if (!continues) return Position < text.Length;
        }
    }

    /// <summary>The next word of this line as a number.</summary>
    /// <param name="what">What the number is, for a message.</param>
    public double NextNumber(string what) => ToNumber(NextInLine(), what);

    /// <summary>Reads a word as a number.</summary>
    /// <param name="word">The word that came last.</param>
    /// <param name="what">What the number is, for a message.</param>
    /// <exception cref="MeshFileException">It is something else, NaN, or beyond the largest number.</exception>
    public double ToNumber(ReadOnlySpan<byte> word, string what)
    {
        if (DecimalNumber.TryParse(word, out var number)) return number;
        throw Error(word.IsEmpty ? $"{what} is missing" : $"{what} must be a finite number, but is {Quoted}");
    }

    /// <summary>A mistake in the last word.</summary>
    public MeshFileException Error(string reason) => source.ErrorAtLine(WordAt, reason);

    private int SkipBlanks()
    {
        var at = Position;
        while (at < text.Length)
        {
            if (text[at] is (byte)' ' or (byte)'\t' or (byte)'\v' or (byte)'\f')
                at++;
            else if (isObj && text[at] == '\\' && LineEnd(text.AsSpan(at + 1)) is > 0 and var end)
                at += 1 + end;
            else if (isObj && text[at] == '#')
                return text.AsSpan(at).IndexOfAny((byte)'\n', (byte)'\r') is >= 0 and var length ? at + length : text.Length;
            else
                break;
        }
        return at;
    }

    private bool EndsWord(byte c) =>
        c is (byte)' ' or (>= (byte)'\t' and <= (byte)'\r') || (isObj && c is (byte)'#' or (byte)'\\');

    /// <summary>How many bytes a line end has that the text begins with; 0 for none.</summary>
    private static int LineEnd(ReadOnlySpan<byte> text) => text switch
    {
        [(byte)'\r', (byte)'\n', ..] => 2,
        [(byte)'\r' or (byte)'\n', ..] => 1,
        _ => 0,
    };
}
