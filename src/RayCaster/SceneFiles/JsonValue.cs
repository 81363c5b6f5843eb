using System.Globalization;
using System.Text;
using System.Text.Json;

namespace RayCaster;

/// <summary>A value in a JSON text.</summary>
/// <param name="tree">The text.</param>
/// <param name="node">The value's token.</param>
internal readonly struct JsonValue(JsonTree tree, int node)
{
    /// <summary>What it is.</summary>
    public JsonKind Kind => tree[node].Kind;

    /// <summary>The place of its first byte.</summary>
    public int Start => tree[node].Start;

    /// <summary>The place after its last byte.</summary>
    public int End => tree[node].End;

    /// <summary>How it is written, shortened if it is long.</summary>
    public string AsWritten => tree.Text.Quote(Start, End);

    /// <summary>What an array holds: elements; what an object holds: key, value, key, value …</summary>
    public JsonValue[] Content
    {
        get
        {
            var (count, end) = (0, tree[node].Next);
            for (var i = node + 1; i < end; i = tree[i].Next) count++;
            var content = new JsonValue[count];
            for (var (i, place) = (node + 1, 0); i < end; i = tree[i].Next) content[place++] = new(tree, i);
            return content;
        }
    }

    /// <summary>The number nearest to the one that is written; ±∞ beyond the largest.</summary>
    public double Number => double.Parse(tree.Text.Utf8[Start..End], NumberStyles.Float, CultureInfo.InvariantCulture);

    /// <summary>A text or key without its quotes and escapes; as written if it holds half a surrogate pair, which is no text.</summary>
    public string Text
    {
        get
        {
            var content = tree.Text.Utf8[(Start + 1)..(End - 1)];
            return content.IndexOf((byte)'\\') < 0 ? Encoding.UTF8.GetString(content) : Unescaped();
        }
    }

    /// <summary>What it is, in words: <c>the text "45"</c>.</summary>
    public string InWords => Kind switch
    {
        JsonKind.Object => "an object",
        JsonKind.Array => "an array",
        JsonKind.Text => $"the text {AsWritten}",
        _ => AsWritten, // a number, true, false or null
    };

    private string Unescaped()
    {
        var reader = new Utf8JsonReader(tree.Text.Utf8[Start..End]);
        reader.Read();
        try
        {
            return reader.GetString()!;
        }
        catch (InvalidOperationException)
        {
            return tree.Text.Quote(Start + 1, End - 1);
        }
    }
}
