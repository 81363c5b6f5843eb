using System.Buffers.Text;

namespace RayCaster.Files;

/// <summary>A value or a key in a JSON text. One that is not what a scene needs is reported, and NaN or null returned.</summary>
/// <param name="path">The path of the value, or of the array whose element it is; empty for the outermost object, and where nobody asked.</param>
internal readonly struct JsonValue(JsonTree tree, int node, string path = "", int? element = null)
{
    public const string VectorForm = "an array of three numbers [x, y, z]";

    public static readonly Vector3 NoVector = new(double.NaN, double.NaN, double.NaN);

    public SceneReading Reading => tree.Reading;

    /// <summary>As messages name it: <c>models[3].min[1]</c>.</summary>
    public string Path => element is null ? path : $"{path}[{element}]";

    public JsonTokenType Kind => tree[node].Kind;

    public int Start => tree[node].Start;

    /// <summary>The place after its last byte.</summary>
    public int End => tree[node].End;

    public string AsWritten => tree.Text.Quote(Start, End);

    /// <summary>The elements of an array; of an object key, value, key, value …</summary>
    public IEnumerable<JsonValue> Content
    {
        get
        {
            for (int i = node + 1, end = tree[node].Next; i < end; i = tree[i].Next) yield return new(tree, i);
        }
    }

    public int Count
    {
        get
        {
            var count = 0;
            for (int i = node + 1, end = tree[node].Next; i < end; i = tree[i].Next) count++;
            return count;
        }
    }

    /// <summary>An element of an array; those before it are passed one by one.</summary>
    public JsonValue this[int index]
    {
        get
        {
            var i = node + 1;
            for (var before = 0; before < index; before++) i = tree[i].Next;
            return new(tree, i, Path, index);
        }
    }

    /// <summary>The elements of an array with their paths, until there are too many errors.</summary>
    public IEnumerable<JsonValue> Elements
    {
        get
        {
            var (array, index, end) = (Path, 0, tree[node].Next);
            for (var i = node + 1; i < end && !Reading.HasTooManyErrors; i = tree[i].Next) yield return new(tree, i, array, index++);
        }
    }

    public IEnumerable<JsonValue> Keys => Content.Where((_, i) => i % 2 == 0);

    /// <summary>The value of a key of an object, the first if the key is repeated; null if it is missing.</summary>
    /// <param name="valuePath">The value's path.</param>
    public JsonValue? Find(string name, string valuePath = "")
    {
        for (int key = node + 1, end = tree[node].Next; key < end; key = tree[key + 1].Next)
        {
            tree.KeysLookedAt++;
            if (new JsonValue(tree, key).Is(name)) return new(tree, key + 1, valuePath);
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

    public double Limited(Limits limits)
    {
        var number = Kind == JsonTokenType.Number ? Number : double.NaN;
        if (double.IsFinite(number) && limits.Allow(number)) return number;
        var isQuoted = Kind == JsonTokenType.String && double.TryParse(Text, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
        Report(true,
            Kind != JsonTokenType.Number ? $" must be a number, but is {InWords}{(isQuoted ? "; remove the quotes" : "")}"
            : double.IsFinite(number) ? $" must be {limits.Words}, but is {AsWritten}"
            : $" must be finite, but {AsWritten} is beyond the largest number, 1.8e308");
        return double.NaN;
    }

    public double Whole(Limits limits)
    {
        if (Kind != JsonTokenType.Number || !double.IsFinite(Number) || double.IsInteger(Number)) return Limited(limits);
        Report(true, " must be a whole number, but is " + AsWritten);
        return double.NaN;
    }

    public Vector3 Vector(Limits limits, string form = VectorForm)
    {
        if (Kind == JsonTokenType.StartArray && Count == 3)
            return new(this[0].Limited(limits), this[1].Limited(limits), this[2].Limited(limits));
        var found = Kind == JsonTokenType.StartArray
            ? $"has {Digits.Count(Count, "element")}{DecimalComma.Hint([.. Content.Take(7)])}"
            : $"is {InWords}";
        Report(true, $" must be {form}, but {found}");
        return NoVector;
    }

    /// <summary>Three numbers of at least 0, or a text like <c>"#ff8800"</c>: each pair of digits / 255.</summary>
    public Color? Color()
    {
        const string form = "an array of three numbers [red, green, blue] or a text like \"#ff8800\"";
        if (Kind == JsonTokenType.String)
        {
            if (Text is ['#', ..] and { Length: 7 } text && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, null, out var rgb))
                return new((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
            Report(true, $" must be {form}, but is {InWords}; # and six hexadecimal digits make a colour");
            return null;
        }
        var c = Vector(Limits.NotNegative, form);
        if (Math.Max(c.X, Math.Max(c.Y, c.Z)) is > 9 and <= 255 && double.IsInteger(c.X) && double.IsInteger(c.Y) && double.IsInteger(c.Z))
            Report(false, $" is {c}; 0 to 255? Colours here are 0 to 1, and 1 is full intensity");
        return new(c.X, c.Y, c.Z);
    }

    public void AddTriangles(Limits limits, List<int> triangles)
    {
        if (!IsArray("indices")) return;
        var (first, previous) = (0, 0);
        var count = 0;
        foreach (var index in Elements)
        {
            var corner = (int)index.Whole(limits);
            if (count >= 2) triangles.AddRange([first, previous, corner]);
            if (count == 0) first = corner;
            previous = corner;
            count++;
        }
        if (count < 3) Report(true, $" must have at least three indices, but has {count}");
    }

    public string? OneOf(string[] words)
    {
        if (!IsText()) return null;
        foreach (var word in words)
            if (Is(word)) return word;
        Report(true, $" must be {Quoted(words)}, but is {AsWritten}{Spelling.DidYouMean(Text, words)}");
        return Spelling.Nearest(Text, words);
    }

    public bool IsText() => Is(JsonTokenType.String, "a text in double quotes");

    public bool IsFileName()
    {
        if (!IsText()) return false;
        if (Text.Contains('\0')) Report(true, " must not hold the character U+0000, which no file name has");
        else if (Text.AsSpan().IndexOfAnyInRange('\b', '\r') is >= 0 and var at)
            Report(true, $": {PrintableText.Escaped(Text[at..(at + 1)])} in a text is {(Text[at] == '\t' ? "a tab" : "a control character")}: " +
                "write / or \\\\ between folders");
        else return true;
        return false;
    }

    public bool IsArray(string elements) => Is(JsonTokenType.StartArray, $"an array of {elements} in brackets [ ]");

    /// <param name="message">Follows the value's path.</param>
    public void Report(bool isError, string message) => Reading.Add(isError, Start, End, Path + message);

    /// <summary><c>"corner" or "center"</c>.</summary>
    public static string Quoted(string[] words)
    {
        var quoted = Array.ConvertAll(words, word => $"\"{word}\"");
        return quoted.Length == 1 ? quoted[0] : $"{string.Join(", ", quoted[..^1])} or {quoted[^1]}";
    }

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

    private bool Is(JsonTokenType kind, string form)
    {
        if (Kind != kind) Report(true, $" must be {form}, but is {InWords}");
        return Kind == kind;
    }
}
