using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>The text of a file, and the lines and columns of its bytes.</summary>
internal sealed class SourceText(string name, ReadOnlyMemory<byte> utf8)
{
    private const int LongestExcerpt = 120;
    private readonly ArraySegment<byte> bytes = MemoryMarshal.TryGetArray(utf8, out var array) ? array : utf8.ToArray();
    private readonly int mark = utf8.Span.StartsWith("\uFEFF"u8) ? 3 : 0; // the bytes of a byte order mark
    private (int Offset, int Column) last = (0, 1); // the last result of Locate, from which it goes on: a long line may have many problems

    public string Name => name;

    public ReadOnlySpan<byte> Mark => bytes.AsSpan(0, mark);

    public ReadOnlySpan<byte> Utf8 => bytes.AsSpan(mark);

    public string Quote(int start, int end)
    {
        var text = Encoding.UTF8.GetString(Utf8[start..Math.Min(end, start + 240)]);
        var cut = text.AsSpan().IndexOfAny('\r', '\n') is >= 0 and var lineEnd ? lineEnd : text.Length;
        cut = BetweenLetters(text, Math.Min(cut, 60));
        return PrintableText.Escaped(cut < text.Length || start + 240 < end ? string.Concat(text.AsSpan(0, cut), "…") : text);
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

    public int LineOf(int offset)
    {
        var found = Array.BinarySearch(LineStarts, offset);
        return found >= 0 ? found + 1 : ~found;
    }

    /// <summary>The line in which a value starts, with the value underlined; of a long line only the part around the start.</summary>
    public string Excerpt(int start, int end)
    {
        const int most = 4 * LongestExcerpt; // bytes: the line may be the whole file
        var line = LineOf(start);
        var before = Encoding.UTF8.GetString(Utf8[Math.Max(LineStarts[line - 1], start - most)..start]);
        var after = Encoding.UTF8.GetString(Utf8[start..Math.Min(start + most, Utf8.Length)]).Split('\r', '\n')[0];
        if (before.Length > LongestExcerpt / 2 && before.Length + after.Length > LongestExcerpt)
            before = "…" + before[BetweenLetters(before, before.Length - LongestExcerpt / 2)..];
        var room = Math.Min(after.Length, LongestExcerpt - Math.Min(before.Length, LongestExcerpt));
        var value = Math.Min(room, Encoding.UTF8.GetCharCount(Utf8[start..Math.Min(end, start + most)]));
        if (room < after.Length) after = after[..BetweenLetters(after, room)] + "…";
        var indent = string.Concat(before.Select(c => c == '\t' ? c : ' '));
        return PrintableText.From($"{line,5} | {before}{after}").TrimEnd() + $"\n      | {indent}^{new string('~', Math.Max(0, value - 1))}";
    }

    /// <summary>A place at which a text can be cut: not within an emoji, which has two UTF-16 units.</summary>
    private static int BetweenLetters(string text, int index) =>
        index < text.Length && char.IsLowSurrogate(text[index]) ? index - 1 : index;

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
}
