using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>The text of a file, and the lines and columns of its bytes.</summary>
/// <param name="name">The file as the user named it.</param>
internal sealed class SourceText(string name, ReadOnlyMemory<byte> utf8)
{
    private const int LongestExcerpt = 120;
    private readonly ArraySegment<byte> bytes = MemoryMarshal.TryGetArray(utf8, out var array) ? array : utf8.ToArray();
    private readonly int mark = utf8.Span.StartsWith("\uFEFF"u8) ? 3 : 0; // the bytes of a byte order mark
    private (int Offset, int Column) last = (0, 1); // the last result of Locate, from which it goes on: a long line may have many problems

    public string Name => name;

    public ReadOnlySpan<byte> Mark => bytes.AsSpan(0, mark);

    public ReadOnlySpan<byte> Utf8 => bytes.AsSpan(mark);

    /// <summary>A part of the text as written, shortened if it is long.</summary>
    public string Quote(int start, int end)
    {
        var text = Encoding.UTF8.GetString(Utf8[start..Math.Min(end, start + 240)]);
        var cut = text.AsSpan().IndexOfAny('\r', '\n') is >= 0 and var lineEnd ? lineEnd : text.Length;
        cut = Math.Min(cut, 60);
        return PrintableText.Of(cut < text.Length || start + 240 < end ? string.Concat(text.AsSpan(0, cut), "…") : text);
    }

    /// <summary>The line of a byte, from 1, and its column, from 1, in UTF-16 units. LF, CR LF and CR end a line.</summary>
    public (int Line, int Column) Locate(int offset)
    {
        var line = LineOf(offset);
        var from = LineStarts[line - 1];
        var column = 1;
        if (last.Offset >= from && last.Offset <= offset) (from, column) = last;
        column += Encoding.UTF8.GetCharCount(Utf8[from..offset]);
        last = (offset, column);
        return (line, column);
    }

    /// <summary>The line of a byte, from 1.</summary>
    public int LineOf(int offset)
    {
        var found = Array.BinarySearch(LineStarts, offset);
        return found >= 0 ? found + 1 : ~found;
    }

    /// <summary>The line in which a value starts, with the value underlined; of a long line only the part around the start.</summary>
    public string Excerpt(int start, int end)
    {
        var line = LineOf(start);
        var from = LineStarts[line - 1];
        var ahead = Utf8.Slice(start, Math.Min(4 * LongestExcerpt, Utf8.Length - start)); // not the whole line, which may be the whole file
        var to = start + (ahead.IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? length : ahead.Length);
        end = Math.Clamp(end, start, to);

        var cutBefore = to - from > LongestExcerpt && start - from > LongestExcerpt / 2;
        if (cutBefore) from = WholeCharacter(start - LongestExcerpt / 2);
        var cutAfter = to - from > LongestExcerpt;
        if (cutAfter) to = Math.Max(start, WholeCharacter(from + LongestExcerpt));
        end = Math.Min(end, to);

        var before = (cutBefore ? "…" : "") + PrintableText.Of(Encoding.UTF8.GetString(Utf8[from..start]));
        var value = PrintableText.Of(Encoding.UTF8.GetString(Utf8[start..end]));
        var after = PrintableText.Of(Encoding.UTF8.GetString(Utf8[end..to])) + (cutAfter ? "…" : "");
        var indent = string.Concat(before.Select(c => c == '\t' ? c : ' '));
        return $"{line,5} | {before}{value}{after}".TrimEnd() + $"\n      | {indent}^{new string('~', Math.Max(0, value.Length - 1))}";
    }

    private int[] LineStarts => field ??= FindLineStarts();

    private int[] FindLineStarts()
    {
        var starts = new List<int> { 0 };
        for (var i = 0; Utf8[i..].IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var next;)
        {
            i += next + 1;
            if (Utf8[i - 1] == '\r' && i < Utf8.Length && Utf8[i] == '\n') i++;
            starts.Add(i);
        }
        return [.. starts];
    }

    /// <summary>The place where the character of a byte starts, up to three bytes before. Bytes that are not UTF-8 have no such place.</summary>
    private int WholeCharacter(int offset)
    {
        for (var back = 0; back <= 3; back++)
            if ((Utf8[offset - back] & 0xC0) != 0x80)
                return offset - back;
        return offset;
    }
}
