using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>A value or a key in a JSON text.</summary>
internal readonly struct JsonValue(JsonTree tree, int node)
{
    public JsonTokenType Kind => tree[node].Kind;

    /// <summary>The place of its first byte.</summary>
    public int Start => tree[node].Start;

    /// <summary>The place after its last byte.</summary>
    public int End => tree[node].End;

    /// <summary>The text of the value, shortened if it is long.</summary>
    public string AsWritten => tree.Text.Quote(Start, End);

    /// <summary>The elements of an array; of an object key, value, key, value …</summary>
    public IEnumerable<JsonValue> Content
    {
        get
        {
            for (int i = node + 1, end = tree[node].Next; i < end; i = tree[i].Next) yield return new(tree, i);
        }
    }

    /// <summary>How many values the content has.</summary>
    public int Count
    {
        get
        {
            var count = 0;
            for (int i = node + 1, end = tree[node].Next; i < end; i = tree[i].Next) count++;
            return count;
        }
    }

    /// <summary>A value of the content; those before it are passed one by one.</summary>
    public JsonValue this[int index]
    {
        get
        {
            var i = node + 1;
            for (; index > 0; index--) i = tree[i].Next;
            return new(tree, i);
        }
    }

    public IEnumerable<JsonValue> Keys => Content.Where((_, i) => i % 2 == 0);

    /// <summary>The value of a key of an object, the first if the key is repeated; null if it is missing.</summary>
    public JsonValue? Find(string name)
    {
        for (int key = node + 1, end = tree[node].Next; key < end; key = tree[key + 1].Next)
        {
            tree.KeysLookedAt++;
            if (new JsonValue(tree, key).Is(name)) return new(tree, key + 1);
        }
        return null;
    }

    /// <summary>Whether a text or key equals this, which must be ASCII.</summary>
    public bool Is(string text)
    {
        var written = tree.Written(node);
        return written.Length > text.Length ? written.IndexOf((byte)'\\') >= 0 && Text == text : Ascii.Equals(written, text);
    }

    /// <summary>The double nearest to the number in the text; ±∞ beyond the largest.</summary>
    public double Number
    {
        get
        {
            Utf8Parser.TryParse(tree.Text.Utf8[Start..End], out double number, out _);
            return number;
        }
    }

    /// <summary>Whether it is a number that is written without a point and an exponent.</summary>
    public bool IsWholeNumber => Kind == JsonTokenType.Number && tree.Text.Utf8[Start..End].IndexOfAny(".eE"u8) < 0;

    /// <summary>A text or key without quotes and escapes; with its escapes if they contain half a surrogate pair, which is no character.</summary>
    public string Text
    {
        get
        {
            var content = tree.Written(node);
            return content.IndexOf((byte)'\\') < 0 ? Encoding.UTF8.GetString(content) : Unescaped();
        }
    }

    /// <summary>The value in words: <c>the text "45"</c>.</summary>
    public string InWords => Kind switch
    {
        JsonTokenType.StartObject => "an object",
        JsonTokenType.StartArray => "an array",
        JsonTokenType.String => $"the text {AsWritten}",
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
