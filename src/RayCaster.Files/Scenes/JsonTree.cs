namespace RayCaster.Files;

/// <summary>A JSON text as a tree, with the place of each value in the text. Comments and trailing commas are allowed.</summary>
/// <param name="reading">Holds the text, and gets what is wrong with it.</param>
internal sealed class JsonTree(SceneReading reading)
{
    public const int MaxDepth = 64;

    private static readonly JsonReaderOptions options =
        new() { AllowTrailingCommas = true, CommentHandling = JsonCommentHandling.Skip, MaxDepth = MaxDepth };

    private Node[] nodes = new Node[256]; // the first "count" are filled
    private int count;
    private int lastClosed;

    /// <summary>A token; an object's keys stand before their values.</summary>
    /// <param name="Next">The node after this one and all nodes in it.</param>
    public readonly record struct Node(JsonTokenType Kind, int Start, int End, int Next);

    /// <summary>How many keys were compared in searches. It must grow only in proportion to the text, also in a file with many errors.</summary>
    public long KeysLookedAt;

    public SceneReading Reading => reading;

    public SourceText Text => reading.Source;

    public JsonValue Root => new(this, 0);

    public Node this[int node] => nodes[node];

    /// <summary>The bytes between the quotes of a text or key.</summary>
    public ReadOnlySpan<byte> Written(int node) => Text.Utf8[(nodes[node].Start + 1)..(nodes[node].End - 1)];

    public int Count => count;

    public Node Last => nodes[count - 1];

    /// <summary>The key of the object or array that was closed last; null if it is an element of an array, or the outermost.</summary>
    public int? KeyOfLastClosed => lastClosed > 0 && nodes[lastClosed - 1].Kind == JsonTokenType.PropertyName ? lastClosed - 1 : null;

    /// <summary>The text with other values in place of some, in ASCII; comments and layout stay.</summary>
    public byte[] With(IEnumerable<(JsonValue Value, string Text)> edits)
    {
        var text = new MemoryStream();
        var done = 0;
        text.Write(Text.Mark);
        foreach (var (value, by) in edits.OrderBy(edit => edit.Value.Start))
        {
            text.Write(Text.Utf8[done..value.Start]);
            text.Write(Encoding.ASCII.GetBytes(by));
            done = value.End;
        }
        text.Write(Text.Utf8[done..]);
        return text.ToArray();
    }

    private void Add(JsonTokenType kind, int start, int end)
    {
        if (count == nodes.Length) Array.Resize(ref nodes, 2 * count);
        nodes[count++] = new(kind, start, end, count);
    }

    /// <summary>The tree; null, after a report, if the text is not JSON.</summary>
    /// <param name="takesText">Whether the value of a key may be a text: then a word without quotes gets that advice.</param>
    public static JsonTree? Parse(SceneReading reading, Predicate<string>? takesText = null)
    {
        var text = reading.Source;
        if (FileSignature.NotUtf8(text.Utf8) is var (at, message))
        {
            reading.Add(true, at, at, message);
            return null;
        }
        var tree = new JsonTree(reading);
        var open = new int[MaxDepth]; // the arrays and objects that are not closed yet
        var depth = 0;
        var reader = new Utf8JsonReader(text.Utf8, options);
        var last = JsonTokenType.None;
        var lastEnd = 0;
        try
        {
            while (reader.Read())
            {
                last = reader.TokenType;
                lastEnd = (int)reader.BytesConsumed; // a key's ends after its colon
                if (last is JsonTokenType.EndObject or JsonTokenType.EndArray)
                {
                    tree.lastClosed = open[--depth];
                    tree.nodes[tree.lastClosed] = tree.nodes[tree.lastClosed] with { End = lastEnd, Next = tree.count };
                    continue;
                }
                if (last is JsonTokenType.StartObject or JsonTokenType.StartArray) open[depth++] = tree.count;
                var start = (int)reader.TokenStartIndex;
                var end = last == JsonTokenType.PropertyName ? start + reader.ValueSpan.Length + 2 : lastEnd;
                tree.Add(last, start, end);
            }
            return tree;
        }
        catch (JsonException)
        {
            var mistake = new JsonExpectation(tree, open.AsSpan(0, depth), last, lastEnd, takesText ?? (_ => false)).Explain();
            reading.Add(true, mistake.Start, mistake.End, mistake.Message);
            return null;
        }
    }
}
