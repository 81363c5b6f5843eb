namespace RayCaster;

/// <summary>A JSON text as a tree whose values know their place in the text.</summary>
internal sealed class JsonTree
{
    /// <summary>How deep arrays and objects may be nested.</summary>
    public const int MaxDepth = 64;

    private Node[] nodes;
    private int count;

    public JsonTree(SourceText text) => (Text, nodes) = (text, new Node[16 + text.Utf8.Length / 4]);

    /// <summary>A token; an object's keys stand before their values. Plain fields: each property would be one more method to compile at start-up.</summary>
    public struct Node
    {
        /// <summary>What it is.</summary>
        public JsonKind Kind;

        /// <summary>The place of its first byte.</summary>
        public int Start;

        /// <summary>The place after its last byte.</summary>
        public int End;

        /// <summary>The node after this one and all that is in it.</summary>
        public int Next;
    }

    /// <summary>The text.</summary>
    public SourceText Text { get; }

    /// <summary>The outermost value.</summary>
    public JsonValue Root => new(this, 0);

    /// <summary>A token by its number in the text.</summary>
    public ref Node this[int node] => ref nodes[node];

    /// <summary>What stands between the quotes of a text or key.</summary>
    public ReadOnlySpan<byte> Written(int node) => Text.Utf8[(nodes[node].Start + 1)..(nodes[node].End - 1)];

    /// <summary>The token that was added last.</summary>
    public Node Last => nodes[count - 1];

    /// <summary>Reads a text.</summary>
    /// <param name="text">The text; valid UTF-8.</param>
    /// <param name="mistake">Why it is not JSON, if null is returned.</param>
    public static JsonTree? Parse(SourceText text, out JsonMistake mistake)
    {
        var tree = new JsonTree(text);
        var scanner = new JsonScanner(tree);
        mistake = default;
        if (scanner.Scan()) return tree;
        mistake = scanner.Mistake;
        return null;
    }

    /// <summary>Adds a token.</summary>
    /// <returns>Its number.</returns>
    public int Add(JsonKind kind, int start, int end)
    {
        if (count == nodes.Length) Array.Resize(ref nodes, 2 * count);
        ref var node = ref nodes[count];
        (node.Kind, node.Start, node.End, node.Next) = (kind, start, end, count + 1);
        return count++;
    }

    /// <summary>Ends an array or object.</summary>
    /// <param name="opening">The number of its token.</param>
    /// <param name="end">The place after its closing bracket.</param>
    public void Close(int opening, int end) => (nodes[opening].End, nodes[opening].Next) = (end, count);
}
