using System.Globalization;

namespace RayCaster;

/// <summary>
/// An object of a scene file. It is read by asking for its keys, one call each. Whatever is wrong is noted with its place, and reading goes on
/// with a value that is no number (NaN): no comparison holds for it, so a rule that says what is refused keeps silent.
/// </summary>
/// <remarks>
/// The same calls describe the keys: an object made by <see cref="Describing"/> has no text behind it, notes no problems and collects what
/// it is asked for. The editors' schema is made of that, so it cannot differ from what is read.
/// </remarks>
internal sealed class SceneObject
{
    private static readonly Vector3 NoVector = new(double.NaN, double.NaN, double.NaN);

    private readonly SceneDocument? document;
    private readonly JsonValue json;
    private readonly string path;
    private readonly JsonValue[] content = []; // key, value, key, value …
    private readonly Dictionary<string, int> written = []; // where in the content the first of each key stands
    private readonly List<string> asked = [];
    private readonly List<SceneKey>? described;
    private readonly int errorsBefore;

    /// <summary>An object in a text. Notes the keys that stand in it twice; the first counts.</summary>
    /// <param name="document">The scene file.</param>
    /// <param name="json">The object.</param>
    /// <param name="path">Its path, empty for the scene itself.</param>
    public SceneObject(SceneDocument document, JsonValue json, string path)
    {
        (this.document, this.json, this.path) = (document, json, path);
        errorsBefore = document.ErrorCount;
        content = json.Content;
        for (var i = 0; i < content.Length && !document.IsHopeless; i += 2)
        {
            var key = content[i].Text;
            if (written.TryAdd(key, i)) continue;
            var line = document.Text.LineOf(content[written[key]].Start);
            Report(true, content[i], PathOf(Shown(key)), $" is given twice; the first is in line {line}");
        }
    }

    private SceneObject(List<SceneKey> described) => (this.described, path) = (described, "");

    /// <summary>The scene file; null where the object is only described.</summary>
    public SceneDocument? Document => document;

    /// <summary>Whether no error was found in this object so far.</summary>
    public bool IsSound => document is null || document.ErrorCount == errorsBefore;

    /// <summary>An object without text that collects the keys it is asked for.</summary>
    public static SceneObject Describing(out IReadOnlyList<SceneKey> keys)
    {
        var described = new List<SceneKey>();
        keys = described;
        return new(described);
    }

    /// <summary>Whether a key is written in the file.</summary>
    public bool Has(string key) => written.ContainsKey(key);

    /// <summary>The path of a value, or of an element of a vector, as messages name it: <c>models[3].min[1]</c>.</summary>
    public string PathOf(string key, int? element = null) =>
        (path.Length > 0 ? $"{path}.{key}" : key) + (element is { } i ? $"[{i}]" : "");

    /// <summary>Any number.</summary>
    public double Number(string key, string meaning, double? orElse = null) => Number(key, meaning, Limits.None, orElse);

    /// <summary>A number greater than 0.</summary>
    public double Positive(string key, string meaning, double? orElse = null) => Number(key, meaning, Limits.Positive, orElse);

    /// <summary>A number within limits.</summary>
    public double Number(string key, string meaning, Limits limits, double? orElse = null) =>
        Take(new(key, KeyKind.Number, meaning, orElse is null, orElse) { Limits = limits }) is { } value
            ? NumberAt(value, key, null, limits)
            : orElse ?? double.NaN;

    /// <summary>A whole number from <paramref name="least"/> to <paramref name="most"/>; the default in place of an erroneous one.</summary>
    public int Whole(string key, string meaning, int least, int most, int orElse)
    {
        var limits = Limits.From(least, most);
        if (Take(new(key, KeyKind.Whole, meaning, false, orElse) { Limits = limits }) is not { } value) return orElse;
        if (value.Kind == JsonKind.Number && double.IsFinite(value.Number) && value.Number != Math.Floor(value.Number))
        {
            Report(true, value, PathOf(key), $" must be a whole number, but is {value.AsWritten}");
            return orElse;
        }
        var number = NumberAt(value, key, null, limits);
        return double.IsNaN(number) ? orElse : (int)number;
    }

    /// <summary>Three numbers.</summary>
    public Vector3 Vector(string key, string meaning, Vector3? orElse = null) =>
        Take(new(key, KeyKind.Vector, meaning, orElse is null, orElse)) is { } value
            ? VectorAt(value, key, Limits.None, "an array of three numbers [x, y, z]")
            : orElse ?? NoVector;

    /// <summary>A vector of any length but zero.</summary>
    public Vector3 Direction(string key, string meaning, Vector3? orElse = null)
    {
        if (Take(new(key, KeyKind.Direction, meaning, orElse is null, orElse)) is not { } value) return orElse ?? NoVector;
        var direction = VectorAt(value, key, Limits.None, "an array of three numbers [x, y, z]");
        if (direction.Length != 0) return direction;
        Report(true, value, PathOf(key), $" must not be {value.AsWritten}: a direction has a length");
        return NoVector;
    }

    /// <summary>A factor for each axis, or one for all; none of them 0.</summary>
    public Vector3 Factors(string key, string meaning, double orElse)
    {
        if (Take(new(key, KeyKind.Factors, meaning, false, orElse)) is not { } value) return new(orElse, orElse, orElse);
        if (value.Kind != JsonKind.Number) return VectorAt(value, key, Limits.NotZero, "a number or an array of three numbers [x, y, z]");
        var factor = NumberAt(value, key, null, Limits.NotZero);
        return new(factor, factor, factor);
    }

    /// <summary>A colour: three numbers of at least 0, or a text like <c>"#ff8800"</c>.</summary>
    public Color Color(string key, string meaning, Color orElse)
    {
        if (Take(new(key, KeyKind.Color, meaning, false, orElse)) is not { } value) return orElse;
        const string What = "an array of three numbers [red, green, blue] or a text like \"#ff8800\"";
        if (value.Kind == JsonKind.Text)
        {
            var text = value.Text;
            if (text.Length == 7 && text[0] == '#' && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, null, out var rgb))
                return new((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
            Report(true, value, PathOf(key), $" must be {What}, but is {value.InWords}; # and six hexadecimal digits make a colour");
            return orElse;
        }
        var color = VectorAt(value, key, Limits.NotNegative, What);
        if (LooksLikeBytes(color)) Warn(key, $" is {color}; 0 to 255? Colours here are 0 to 1, and 1 is full intensity");
        return new(color.X, color.Y, color.Z);
    }

    /// <summary>A text that must be there and must not be empty, or null.</summary>
    public string? Text(string key, string meaning)
    {
        var text = Text(new SceneKey(key, KeyKind.Text, meaning, true));
        if (text is not "") return text;
        Refuse(key, $" must not be empty");
        return null;
    }

    /// <summary>A text, or null where it is left out.</summary>
    public string? OptionalText(string key, string meaning) => Text(new SceneKey(key, KeyKind.Text, meaning, false));

    /// <summary>One of several words; the first where it is left out.</summary>
    public string OptionalChoice(string key, string meaning, params string[] words) =>
        Choice(new SceneKey(key, KeyKind.Choice, meaning, false, words[0]) { Choices = words }) ?? words[0];

    /// <summary>One of several words that must be there, or null.</summary>
    public string? Choice(string key, string meaning, string[] words) => Choice(new SceneKey(key, KeyKind.Choice, meaning, true) { Choices = words });

    /// <summary>An object, or null where there is none.</summary>
    public SceneObject? Object(string key, string meaning)
    {
        if (described is not null)
        {
            var describing = Describing(out var members);
            Take(new(key, KeyKind.Object, meaning, true) { Members = members });
            return describing;
        }
        if (Take(new(key, KeyKind.Object, meaning, true)) is not { } value) return null;
        return AsObject(document!, value, PathOf(key), PathOf(key));
    }

    /// <summary>An array of objects, one after another, so that a million of them are not in memory at a time; without those elements that are none.</summary>
    public IEnumerable<SceneObject> Objects(string key, string meaning)
    {
        if (Take(new(key, KeyKind.Objects, meaning, true)) is not { } value) yield break;
        if (value.Kind != JsonKind.Array)
        {
            Report(true, value, PathOf(key), $" must be an array of objects in brackets [ ], but is {value.InWords}");
            yield break;
        }
        var elements = value.Content;
        for (var i = 0; i < elements.Length && !document!.IsHopeless; i++)
            if (AsObject(document!, elements[i], PathOf(key, i), PathOf(key, i)) is { } element)
                yield return element;
    }

    /// <summary>An object, or null and a problem.</summary>
    /// <param name="document">The scene file.</param>
    /// <param name="value">What should be an object.</param>
    /// <param name="path">Its path.</param>
    /// <param name="name">What a message calls it.</param>
    public static SceneObject? AsObject(SceneDocument document, JsonValue value, string path, string name)
    {
        if (value.Kind == JsonKind.Object) return new(document, value, path);
        document.Add(true, value.Start, value.End, path, $"{name} must be an object in braces {{ }}, but is {value.InWords}");
        return null;
    }

    /// <summary>Refuses a value that was read, or one of its elements: <paramref name="message"/> follows the path.</summary>
    public void Refuse(string key, FormattableString message, int? element = null) =>
        Report(true, Place(key, element), PathOf(key, element), FormattableString.Invariant(message));

    /// <summary>Warns of a value: <paramref name="message"/> follows the path.</summary>
    public void Warn(string key, FormattableString message) =>
        Report(false, Place(key, null), PathOf(key), FormattableString.Invariant(message));

    /// <summary>Refuses the keys that nobody has asked for.</summary>
    /// <param name="allowed">Keys that are right although nobody has asked for them.</param>
    public void Close(params IEnumerable<string> allowed)
    {
        asked.AddRange(allowed);
        foreach (var (key, place) in written)
        {
            if (document!.IsHopeless) return;
            if (asked.Contains(key)) continue;
            Report(true, content[place], PathOf(Shown(key)), " is an unknown key" + RightKey(key));
        }
    }

    /// <summary>A key that may be anything, fit for a message.</summary>
    private static string Shown(string key) => SourceText.Printable(key.Length > 60 ? key[..60] + "…" : key);

    /// <summary>Which key somebody may have meant: first of those that are missing, then of those that are there already.</summary>
    private string RightKey(string wrong)
    {
        var free = asked.FindAll(known => !written.ContainsKey(known));
        if (Spelling.DidYouMean(wrong, free) is { Length: > 0 } help) return help;
        if (Spelling.Nearest(wrong, asked) is { } near && written.TryGetValue(near, out var there))
            return $"; \"{near}\" is already there, in line {document!.Text.LineOf(content[there].Start)}";
        return free.Count is > 0 and <= 8 ? $"; what could be added here is {string.Join(", ", free)}" : "";
    }

    /// <summary>The value of a key, or null if it is not written, which is a problem where it is required.</summary>
    private JsonValue? Take(SceneKey key)
    {
        described?.Add(key);
        asked.Add(key.Name);
        if (written.TryGetValue(key.Name, out var place)) return content[place + 1];
        if (key.IsRequired && document is not null)
        {
            var what = key.Choices.Length > 0 ? InWords(key.Choices) : key.Meaning;
            document.Add(true, json.Start, json.Start + 1, PathOf(key.Name), $"{PathOf(key.Name)} is missing: {what}");
        }
        return null;
    }

    private string? Text(SceneKey key)
    {
        if (Take(key) is not { } value) return null;
        if (value.Kind == JsonKind.Text) return value.Text;
        Report(true, value, PathOf(key.Name), $" must be a text in double quotes, but is {value.InWords}");
        return null;
    }

    private string? Choice(SceneKey key)
    {
        var word = Text(key);
        if (word is null || Array.IndexOf(key.Choices, word) >= 0) return word;
        var value = content[written[key.Name] + 1];
        Report(true, value, PathOf(key.Name), $" must be {InWords(key.Choices)}, but is {value.AsWritten}{Spelling.DidYouMean(word, key.Choices)}");
        return Spelling.Nearest(word, key.Choices);
    }

    private double NumberAt(JsonValue value, string key, int? element, Limits limits)
    {
        if (value.Kind != JsonKind.Number)
        {
            var isQuoted = value.Kind == JsonKind.Text && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
            Report(true, value, PathOf(key, element), $" must be a number, but is {value.InWords}{(isQuoted ? "; remove the quotes" : "")}");
            return double.NaN;
        }
        var number = value.Number;
        if (!double.IsFinite(number))
            Report(true, value, PathOf(key, element), $" must be finite, but {value.AsWritten} is beyond the largest number, 1.8e308");
        else if (!limits.Allow(number))
            Report(true, value, PathOf(key, element), $" must be {limits.Words}, but is {value.AsWritten}");
        else
            return number;
        return double.NaN;
    }

    private Vector3 VectorAt(JsonValue value, string key, Limits limits, string what)
    {
        if (value.Kind != JsonKind.Array)
        {
            Report(true, value, PathOf(key), $" must be {what}, but is {value.InWords}");
            return NoVector;
        }
        var elements = value.Content;
        if (elements.Length == 3) return new(Element(0), Element(1), Element(2));
        Report(true, value, PathOf(key), $" must be {what}, but has {elements.Length} element{(elements.Length == 1 ? "" : "s")}{DecimalComma(elements)}");
        return NoVector;

        double Element(int i) => NumberAt(elements[i], key, i, limits);
    }

    /// <summary>In [2,5, 0, 0] a whole number follows its comma without a blank: somebody may have meant 2.5.</summary>
    private static string DecimalComma(JsonValue[] elements)
    {
        for (var i = 1; i < elements.Length && elements.Length > 3; i++)
        {
            var (whole, fraction) = (elements[i - 1], elements[i]);
            if (fraction.Start == whole.End + 1 && IsWhole(whole) && IsWhole(fraction) && fraction.Number >= 0)
                return $"; a decimal comma? Write {whole.AsWritten}.{fraction.AsWritten}";
        }
        return "";

        static bool IsWhole(JsonValue value) => value.Kind == JsonKind.Number && !value.AsWritten.AsSpan().ContainsAny('.', 'e', 'E');
    }

    private JsonValue? Place(string key, int? element)
    {
        if (!written.TryGetValue(key, out var place)) return null;
        var value = content[place + 1];
        return element is { } i && value.Kind == JsonKind.Array ? value.Content[i] : value;
    }

    /// <summary>Notes a problem; where there is no value at the object's opening brace.</summary>
    private void Report(bool isError, JsonValue? value, string path, string message)
    {
        var (start, end) = value is { } v ? (v.Start, v.End) : (json.Start, json.Start + 1);
        document?.Add(isError, start, end, path, path + message);
    }

    private static bool LooksLikeBytes(Vector3 c) =>
        Math.Max(c.X, Math.Max(c.Y, c.Z)) is > 9 and <= 255 && c.X == Math.Floor(c.X) && c.Y == Math.Floor(c.Y) && c.Z == Math.Floor(c.Z);

    private static string InWords(string[] words)
    {
        var quoted = Array.ConvertAll(words, word => $"\"{word}\"");
        return quoted.Length == 1 ? quoted[0] : $"{string.Join(", ", quoted[..^1])} or {quoted[^1]}";
    }
}
