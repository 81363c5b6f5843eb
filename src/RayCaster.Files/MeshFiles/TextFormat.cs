namespace RayCaster.Files;

/// <summary>A text that can be cut after some of its lines.</summary>
internal abstract class TextFormat(MeshSource source) : MeshFormat
{
    private long position = -1;

    public override bool Next(MeshBlock block)
    {
        if (position == source.Length) return false;
        position = block.Load(Math.Max(position, 0), (text, isEnd) => isEnd ? text.Length : LastCut(text)).End;
        return true;
    }

    /// <summary>The last place in the text at which the next block can begin, after a line end; 0 for none.</summary>
    protected abstract int LastCut(ReadOnlySpan<byte> text);

    /// <summary>Takes the last line that has an end off a text.</summary>
    /// <param name="line">The line without its end. A line that ends with CR and LF comes as an empty line first.</param>
    protected static bool TryTakeLastLine(ref ReadOnlySpan<byte> text, out ReadOnlySpan<byte> line)
    {
        var end = text.LastIndexOfAny((byte)'\n', (byte)'\r');
        line = default;
        if (end < 0) return false;
        text = text[..end];
        line = text[(text.LastIndexOfAny((byte)'\n', (byte)'\r') + 1)..];
        return true;
    }
}
