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
        var reader = new Utf8JsonReader(text.Utf8, new JsonReaderOptions
        {
            AllowTrailingCommas = true,
            CommentHandling = JsonCommentHandling.Skip,
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
        if (kind == JsonTokenType.PropertyName) end = EndOfText(start); // the reader's ends after the colon
        if (kind is JsonTokenType.StartObject or JsonTokenType.StartArray) open.Push(nodes.Count);
        nodes.Add(new(kind, start, end, nodes.Count + 1));
    }

    private int EndOfText(int start)
    {
        var utf8 = Text.Utf8;
        var i = start + 1;
        while (utf8[i] != '"') i += utf8[i] == '\\' ? 2 : 1;
        return i + 1;
    }
}
