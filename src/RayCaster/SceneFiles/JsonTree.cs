using System.Text.Json;

namespace RayCaster;

/// <summary>A JSON text as a tree whose values know their place in the text. Comments and trailing commas are allowed.</summary>
internal sealed class JsonTree
{
    /// <summary>How deep arrays and objects may be nested.</summary>
    public const int MaxDepth = 64;

    private readonly List<Node> nodes = [];

    private JsonTree(SourceText text) => Text = text;

    /// <summary>A token; an object's keys stand before their values.</summary>
    /// <param name="Kind">What it is; of an array or object the start token.</param>
    /// <param name="Start">The place of its first byte.</param>
    /// <param name="End">The place after its last byte.</param>
    /// <param name="Next">The node after this one and all that is in it.</param>
    public readonly record struct Node(JsonTokenType Kind, int Start, int End, int Next);

    /// <summary>The text.</summary>
    public SourceText Text { get; }

    /// <summary>The outermost value.</summary>
    public JsonValue Root => new(this, 0);

    /// <summary>A token by its number in the text.</summary>
    public Node this[int node] => nodes[node];

    /// <summary>The last token that was read.</summary>
    public Node Last => nodes[^1];

    /// <summary>Reads a text.</summary>
    /// <param name="text">The text; valid UTF-8.</param>
    /// <param name="mistake">Why it is not JSON, if null is returned.</param>
    public static JsonTree? Parse(SourceText text, out JsonMistake mistake)
    {
        var tree = new JsonTree(text);
        var open = new Stack<int>();
        var reader = new Utf8JsonReader(WithoutComments(text.Utf8), new JsonReaderOptions
        {
            AllowTrailingCommas = true,
            MaxDepth = MaxDepth,
        });
        var lastEnd = 0;
        var last = JsonTokenType.None;
        try
        {
            while (reader.Read())
            {
                (last, lastEnd) = (reader.TokenType, (int)reader.BytesConsumed);
                tree.Add(last, (int)reader.TokenStartIndex, lastEnd, open);
            }
            mistake = default;
            return tree;
        }
        catch (JsonException e)
        {
            mistake = new JsonExpectation(tree, open, last, lastEnd).Explain(e);
            return null;
        }
    }

    private void Add(JsonTokenType kind, int start, int end, Stack<int> open)
    {
        if (kind is JsonTokenType.EndObject or JsonTokenType.EndArray)
        {
            var opening = open.Pop();
            nodes[opening] = nodes[opening] with { End = end, Next = nodes.Count };
            return;
        }
        if (kind == JsonTokenType.PropertyName) end = EndOfText(Text.Utf8, start); // the reader's ends after the colon
        if (kind is JsonTokenType.StartObject or JsonTokenType.StartArray) open.Push(nodes.Count);
        nodes.Add(new(kind, start, end, nodes.Count + 1));
    }

    /// <summary>The text with blanks in place of comments. The JSON reader's own skipping stumbles over a comment between a key and its colon.</summary>
    private static ReadOnlySpan<byte> WithoutComments(ReadOnlySpan<byte> utf8)
    {
        byte[]? copy = null;
        for (var i = 0; utf8[i..].IndexOfAny((byte)'"', (byte)'/') is >= 0 and var way;)
        {
            i += way;
            var end = i + 1;
            if (utf8[i] == '"')
            {
                end = EndOfText(utf8, i);
            }
            else if (utf8[i..].StartsWith("//"u8))
            {
                end = utf8[i..].IndexOfAny((byte)'\r', (byte)'\n') is >= 0 and var length ? i + length : utf8.Length;
                (copy ??= utf8.ToArray()).AsSpan(i..end).Fill((byte)' ');
            }
            else if (utf8[i..].StartsWith("/*"u8))
            {
                if (utf8[(i + 2)..].IndexOf("*/"u8) is not (>= 0 and var length)) break; // never closed, which the reader refuses
                end = i + length + 4;
                (copy ??= utf8.ToArray()).AsSpan(i..end).Fill((byte)' ');
            }
            i = end;
        }
        return copy ?? utf8;
    }

    /// <summary>The place after the quote that closes a text, or where its line ends without one.</summary>
    private static int EndOfText(ReadOnlySpan<byte> utf8, int start)
    {
        var i = start + 1;
        while (i < utf8.Length && utf8[i] is not ((byte)'"' or (byte)'\r' or (byte)'\n')) i += utf8[i] == '\\' ? 2 : 1;
        return Math.Min(i + 1, utf8.Length);
    }
}
