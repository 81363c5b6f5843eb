namespace RayCaster.Files;

/// <summary>A value that knows its path. A wrong one is reported, and NaN or null returned.</summary>
/// <param name="path">The path of the value, or of the array whose element it is.</param>
internal readonly struct SceneValue(SceneDocument document, JsonValue json, string path, int? element = null)
{
    public const string VectorForm = "an array of three numbers [x, y, z]";

    public static readonly Vector3 NoVector = new(double.NaN, double.NaN, double.NaN);

    public JsonValue Json => json;

    public JsonTokenType Kind => json.Kind;

    public string Text => json.Text;

    /// <summary>The elements of an array, until there are too many errors.</summary>
    public IEnumerable<SceneValue> Elements
    {
        get
        {
            var array = Path;
            var count = 0;
            foreach (var value in json.Content)
            {
                if (document.HasTooManyErrors) yield break;
                yield return new(document, value, array, count++);
            }
        }
    }

    /// <summary>As messages name it: <c>models[3].min[1]</c>.</summary>
    public string Path => element is null ? path : $"{path}[{element}]";

    public double Number(Limits limits)
    {
        var number = json.Kind == JsonTokenType.Number ? json.Number : double.NaN;
        if (double.IsFinite(number) && limits.Allow(number)) return number;
        var isQuoted = json.Kind == JsonTokenType.String && double.TryParse(json.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
        Report(true,
            json.Kind != JsonTokenType.Number ? $" must be a number, but is {json.InWords}{(isQuoted ? "; remove the quotes" : "")}"
            : double.IsFinite(number) ? $" must be {limits.Words}, but is {json.AsWritten}"
            : $" must be finite, but {json.AsWritten} is beyond the largest number, 1.8e308");
        return double.NaN;
    }

    public double Whole(Limits limits)
    {
        if (json.Kind != JsonTokenType.Number || !double.IsFinite(json.Number) || double.IsInteger(json.Number)) return Number(limits);
        Report(true, " must be a whole number, but is " + json.AsWritten);
        return double.NaN;
    }

    public Vector3 Vector(Limits limits, string form = VectorForm)
    {
        if (json.Kind == JsonTokenType.StartArray && json.Count == 3)
            return new(Element(0).Number(limits), Element(1).Number(limits), Element(2).Number(limits));
        var found = json.Kind == JsonTokenType.StartArray
            ? $"has {Plural.Format(json.Count, "element")}{DecimalComma.Hint([.. json.Content.Take(7)])}"
            : $"is {json.InWords}";
        Report(true, $" must be {form}, but {found}");
        return NoVector;
    }

    /// <summary>Three numbers of at least 0, or a text like <c>"#ff8800"</c>: each pair of digits / 255.</summary>
    public Color? Color()
    {
        const string form = "an array of three numbers [red, green, blue] or a text like \"#ff8800\"";
        if (json.Kind == JsonTokenType.String)
        {
            if (json.Text is ['#', ..] and { Length: 7 } text && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, null, out var rgb))
                return new((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
            Report(true, $" must be {form}, but is {json.InWords}; # and six hexadecimal digits make a colour");
            return null;
        }
        var c = Vector(Limits.NotNegative, form);
        if (Math.Max(c.X, Math.Max(c.Y, c.Z)) is > 9 and <= 255 && double.IsInteger(c.X) && double.IsInteger(c.Y) && double.IsInteger(c.Z))
            Report(false, $" is {c}; 0 to 255? Colours here are 0 to 1, and 1 is full intensity");
        return new(c.X, c.Y, c.Z);
    }

    /// <summary>Adds the triangles of a face, an array of at least three indices.</summary>
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
            if (json.Is(word)) return word;
        Report(true, $" must be {Quoted(words)}, but is {json.AsWritten}{Spelling.DidYouMean(json.Text, words)}");
        return Spelling.Nearest(json.Text, words);
    }

    public bool IsText() => Is(JsonTokenType.String, "a text in double quotes");

    public bool IsFileName()
    {
        if (!IsText()) return false;
        if (!json.Text.Contains('\0')) return true;
        Report(true, " must not hold the character U+0000, which no file name has");
        return false;
    }

    public bool IsArray(string elements) => Is(JsonTokenType.StartArray, $"an array of {elements} in brackets [ ]");

    /// <param name="message">Follows the value's path.</param>
    public void Report(bool isError, string message) => document.Add(isError, json.Start, json.End, Path + message);

    /// <summary><c>"corner" or "center"</c>.</summary>
    public static string Quoted(string[] words)
    {
        var quoted = Array.ConvertAll(words, word => $"\"{word}\"");
        return quoted.Length == 1 ? quoted[0] : $"{string.Join(", ", quoted[..^1])} or {quoted[^1]}";
    }

    private SceneValue Element(int index) => new(document, json[index], Path, index);

    private bool Is(JsonTokenType kind, string form)
    {
        if (json.Kind != kind) Report(true, $" must be {form}, but is {json.InWords}");
        return json.Kind == kind;
    }
}
