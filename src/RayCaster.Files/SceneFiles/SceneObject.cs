using System.Globalization;
using System.Text.Json;

namespace RayCaster.Files;

/// <summary>
/// An object of a scene file. It is read by asking for its keys, one call each. Whatever is wrong is noted with its place, and reading goes on
/// with a value that is no number (NaN): no comparison holds for it, so a rule that says what is refused keeps silent.
/// </summary>
/// <remarks>
/// The same calls describe the keys: an object made by <see cref="Describing"/> has no text behind it, notes no problems and collects what
/// it is asked for. The editors' schema is made of that, so it cannot differ from what is read.
/// <para>Messages are put together in methods of their own, which need not be compiled where all is well.</para>
/// </remarks>
internal sealed class SceneObject
{
    private const string WhatColorsAre = "an array of three numbers [red, green, blue] or a text like \"#ff8800\"";
    private static readonly Vector3 NoVector = new(double.NaN, double.NaN, double.NaN);

    private readonly SceneDocument? document;
    private readonly string path;
    private readonly List<string> asked = [];
    private readonly List<SceneKey>? described;
    private JsonValue json;
    private int? index;        // in an array of that path
    private int errorsBefore;
    private int? keyCount;     // null where a key may be there twice
    private int found, likely; // keys that were asked for and are there; where the next may be

    /// <param name="document">The scene file.</param>
    /// <param name="path">The object's path, empty for the scene itself; of the elements of an array that of the array.</param>
    private SceneObject(SceneDocument document, string path) => (this.document, this.path) = (document, path);

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
    public bool Has(string key) => document is not null && json.Find(key) is not null;

    /// <summary>The path of a value, or of an element of a vector, as messages name it: <c>models[3].min[1]</c>.</summary>
    public string PathOf(string key, int? element = null) => path.Length == 0 && element is null ? key : LongPathOf(key, element);

    private string LongPathOf(string key, int? element) =>
        (path.Length > 0 ? $"{path}{(index is { } place ? $"[{place}]" : "")}.{key}" : key) + (element is { } i ? $"[{i}]" : "");

    /// <summary>Any number.</summary>
    public double Number(string key, string meaning, double? orElse = null) => Number(key, meaning, Limits.None, orElse);

    /// <summary>A number greater than 0.</summary>
    public double Positive(string key, string meaning, double? orElse = null) => Number(key, meaning, Limits.Positive, orElse);

    /// <summary>A number within limits.</summary>
    public double Number(string key, string meaning, Limits limits, double? orElse = null)
    {
        described?.Add(new(key, KeyKind.Number, meaning, orElse is null, orElse) { Limits = limits });
        return Take(key, meaning, orElse is null) is { } value ? NumberAt(value, key, null, limits) : orElse ?? double.NaN;
    }

    /// <summary>A whole number from <paramref name="least"/> to <paramref name="most"/>; the default in place of an erroneous one.</summary>
    public int Whole(string key, string meaning, int least, int most, int orElse)
    {
        var limits = Limits.From(least, most);
        described?.Add(new(key, KeyKind.Whole, meaning, false, orElse) { Limits = limits });
        if (Take(key, meaning, false) is not { } value) return orElse;
        if (value.Kind == JsonTokenType.Number && double.IsFinite(value.Number) && value.Number != Math.Floor(value.Number))
        {
            Report(value, key, " must be a whole number, but is " + value.AsWritten);
            return orElse;
        }
        var number = NumberAt(value, key, null, limits);
        return double.IsNaN(number) ? orElse : (int)number;
    }

    /// <summary>Three numbers.</summary>
    public Vector3 Vector(string key, string meaning, Vector3? orElse = null)
    {
        described?.Add(new(key, KeyKind.Vector, meaning, orElse is null, orElse));
        return Take(key, meaning, orElse is null) is { } value
            ? VectorAt(value, key, Limits.None, "an array of three numbers [x, y, z]")
            : orElse ?? NoVector;
    }

    /// <summary>A vector of any length but zero.</summary>
    public Vector3 Direction(string key, string meaning, Vector3? orElse = null)
    {
        described?.Add(new(key, KeyKind.Direction, meaning, orElse is null, orElse));
        if (Take(key, meaning, orElse is null) is not { } value) return orElse ?? NoVector;
        var direction = VectorAt(value, key, Limits.None, "an array of three numbers [x, y, z]");
        if (direction.Length != 0) return direction;
        Report(value, key, " must not be " + value.AsWritten + ": a direction has a length");
        return NoVector;
    }

    /// <summary>A factor for each axis, or one for all; none of them 0.</summary>
    public Vector3 Factors(string key, string meaning, double orElse)
    {
        described?.Add(new(key, KeyKind.Factors, meaning, false, orElse));
        if (Take(key, meaning, false) is not { } value) return new(orElse, orElse, orElse);
        if (value.Kind != JsonTokenType.Number) return VectorAt(value, key, Limits.NotZero, "a number or an array of three numbers [x, y, z]");
        var factor = NumberAt(value, key, null, Limits.NotZero);
        return new(factor, factor, factor);
    }

    /// <summary>A colour: three numbers of at least 0, or a text like <c>"#ff8800"</c>.</summary>
    public Color Color(string key, string meaning, Color orElse)
    {
        described?.Add(new(key, KeyKind.Color, meaning, false, orElse));
        if (Take(key, meaning, false) is not { } value) return orElse;
        if (value.Kind == JsonTokenType.String) return HexColorAt(value, key) ?? orElse;
        var color = VectorAt(value, key, Limits.NotNegative, WhatColorsAre);
        if (LooksLikeBytes(color)) WarnOfBytes(key, color);
        return new(color.X, color.Y, color.Z);
    }

    /// <summary>A text that must be there and must not be empty, or null.</summary>
    public string? Text(string key, string meaning)
    {
        var text = Text(key, meaning, true);
        if (text is not "") return text;
        Refuse(key, $" must not be empty");
        return null;
    }

    /// <summary>A text, or null where it is left out.</summary>
    public string? OptionalText(string key, string meaning) => Text(key, meaning, false);

    /// <summary>An array of texts, without those elements that are none; empty where it is left out.</summary>
    public IReadOnlyList<string> Texts(string key, string meaning, bool isRequired)
    {
        described?.Add(new(key, KeyKind.Texts, meaning, isRequired));
        if (Take(key, meaning, isRequired) is not { } value) return [];
        if (value.Kind == JsonTokenType.StartArray)
            return [.. value.Content.Where((text, i) => IsText(text, key, i)).Select(text => text.Text)];
        Report(value, key, " must be an array of texts in brackets [ ], but is " + value.InWords);
        return [];
    }

    /// <summary>One of several words; the first where it is left out.</summary>
    public string OptionalChoice(string key, string meaning, params string[] words) =>
        Choice(key, meaning, words[0], words) ?? words[0];

    /// <summary>One of several words that must be there, or null.</summary>
    public string? Choice(string key, string meaning, string[] words) => Choice(key, meaning, null, words);

    /// <summary>An object, or null where there is none.</summary>
    public SceneObject? Object(string key, string meaning)
    {
        if (described is not null)
        {
            var describing = Describing(out var members);
            described.Add(new(key, KeyKind.Object, meaning, true) { Members = members });
            return describing;
        }
        return Take(key, meaning, true) is { } value ? AsObject(document!, value, PathOf(key)) : null;
    }

    /// <summary>
    /// An array of objects, one after another, so that a million of them are not in memory at a time; without those elements that are none. It is
    /// the same
    /// one each time: the caller is done with an element when it takes the next.
    /// </summary>
    public IEnumerable<SceneObject> Objects(string key, string meaning)
    {
        described?.Add(new(key, KeyKind.Objects, meaning, true));
        if (Take(key, meaning, true) is not { } value) yield break;
        if (value.Kind != JsonTokenType.StartArray)
        {
            Report(value, key, " must be an array of objects in brackets [ ], but is " + value.InWords);
            yield break;
        }
        var (i, o) = (0, new SceneObject(document!, PathOf(key)));
        for (var next = value.First; next is { } element && !document!.IsHopeless; next = value.After(element), i++)
            if (o.IsNow(element, i))
                yield return o;
    }

    /// <summary>An object, or null and a problem.</summary>
    /// <param name="document">The scene file.</param>
    /// <param name="value">What should be an object.</param>
    /// <param name="path">Its path, empty for the outermost.</param>
    /// <param name="name">What a message calls it, if not by its path.</param>
    public static SceneObject? AsObject(SceneDocument document, JsonValue value, string path, string? name = null)
    {
        var o = new SceneObject(document, path);
        return o.IsNow(value, null, name) ? o : null;
    }

    /// <summary>Begins an object in the text, and notes the keys that stand in it twice, of which the first counts; false and a problem where it
    /// is none.</summary>
    /// <param name="value">What should be an object.</param>
    /// <param name="place">Its place in the array.</param>
    /// <param name="name">What a message calls it, if not by its path.</param>
    private bool IsNow(JsonValue value, int? place, string? name = null)
    {
        if (value.Kind != JsonTokenType.StartObject)
        {
            RefuseAsObject(value, place, name);
            return false;
        }
        (json, index, errorsBefore, keyCount, found, likely) = (value, place, document!.ErrorCount, value.CountKeys(), 0, 0);
        asked.Clear();
        if (keyCount is null) RefuseRepeatedKeys(document);
        return true;
    }

    private void RefuseAsObject(JsonValue value, int? place, string? name)
    {
        var whole = place is null ? path : $"{path}[{place}]";
        document!.Add(true, value.Start, value.End, whole, $"{name ?? whole} must be an object in braces {{ }}, but is {value.InWords}");
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
        if (document is not null && found != keyCount) RefuseUnknownKeys(document, allowed);
    }

    private void RefuseUnknownKeys(SceneDocument document, IEnumerable<string> allowed)
    {
        asked.AddRange(allowed);
        var places = new Dictionary<string, JsonValue>(); // each key once, though it may be there twice
        foreach (var key in json.Keys) places.TryAdd(key.Text, key);
        var free = asked.FindAll(known => !places.ContainsKey(known)); // once for all unknown keys: there may be as many as there are bytes
        foreach (var (name, key) in places)
        {
            if (document.IsHopeless) return;
            if (!asked.Contains(name)) Report(true, key, PathOf(Shown(name)), " is an unknown key" + RightKey(name, free, places));
        }
    }

    private void RefuseRepeatedKeys(SceneDocument document)
    {
        var lines = new Dictionary<string, int>();
        foreach (var key in json.Keys)
        {
            if (document.IsHopeless) return;
            if (lines.TryAdd(key.Text, document.Text.LineOf(key.Start))) continue;
            Report(true, key, PathOf(Shown(key.Text)), $" is given twice; the first is in line {lines[key.Text]}");
        }
    }

    /// <summary>A key that may be anything, fit for a message.</summary>
    private static string Shown(string key) => PrintableText.Of(key.Length > 60 ? key[..60] + "…" : key);

    /// <summary>Which key somebody may have meant: first of those that are missing, then of those that are there already.</summary>
    private string RightKey(string wrong, List<string> free, Dictionary<string, JsonValue> places)
    {
        if (Spelling.DidYouMean(wrong, free) is { Length: > 0 } help) return help;
        if (Spelling.Nearest(wrong, asked) is { } near && places.TryGetValue(near, out var there))
            return $"; \"{near}\" is already there, in line {document!.Text.LineOf(there.Start)}";
        return free.Count is > 0 and <= 8 ? $"; what could be added here is {string.Join(", ", free)}" : "";
    }

    /// <summary>The value of a key that has not been asked for before, or null if it is not written, which is a problem where it is
    /// required.</summary>
    private JsonValue? Take(string key, string meaning, bool isRequired, string[]? words = null)
    {
        if (document is null) return null;
        asked.Add(key);
        var value = keyCount is null ? json.Find(key) : json.Find(key, ref likely);
        if (value is not null) found++;
        if (value is null && isRequired)
            Report(true, null, PathOf(key), " is missing: " + (words is null ? meaning : InWords(words)));
        return value;
    }

    private string? Text(string key, string meaning, bool isRequired)
    {
        described?.Add(new(key, KeyKind.Text, meaning, isRequired));
        return Take(key, meaning, isRequired) is { } value && IsText(value, key) ? value.Text : null;
    }

    private bool IsText(JsonValue value, string key, int? element = null)
    {
        if (value.Kind == JsonTokenType.String) return true;
        Report(value, key, " must be a text in double quotes, but is " + value.InWords, element);
        return false;
    }

    private string? Choice(string key, string meaning, string? orElse, string[] words)
    {
        described?.Add(new(key, KeyKind.Choice, meaning, orElse is null, orElse) { Choices = words });
        if (Take(key, meaning, orElse is null, words) is not { } value || !IsText(value, key)) return null;
        foreach (var word in words)
            if (value.Is(word))
                return word;
        return NearestWord(value, key, words);
    }

    private string? NearestWord(JsonValue value, string key, string[] words)
    {
        Report(value, key, $" must be {InWords(words)}, but is {value.AsWritten}{Spelling.DidYouMean(value.Text, words)}");
        return Spelling.Nearest(value.Text, words);
    }

    private double NumberAt(JsonValue value, string key, int? element, Limits limits)
    {
        if (value.Kind == JsonTokenType.Number && value.Number is var number && double.IsFinite(number) && limits.Allow(number)) return number;
        Report(value, key, WrongNumber(value, limits), element);
        return double.NaN;
    }

    private static string WrongNumber(JsonValue value, Limits limits)
    {
        if (value.Kind == JsonTokenType.Number)
            return double.IsFinite(value.Number)
                ? $" must be {limits.Words}, but is {value.AsWritten}"
                : $" must be finite, but {value.AsWritten} is beyond the largest number, 1.8e308";
        var isQuoted = value.Kind == JsonTokenType.String && double.TryParse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture, out _);
        return $" must be a number, but is {value.InWords}{(isQuoted ? "; remove the quotes" : "")}";
    }

    private Vector3 VectorAt(JsonValue value, string key, Limits limits, string what)
    {
        if (value.Kind == JsonTokenType.StartArray && value.IsOfThree(out var x, out var y, out var z))
            return new(NumberAt(x, key, 0, limits), NumberAt(y, key, 1, limits), NumberAt(z, key, 2, limits));
        Report(value, key, WrongVector(value, what));
        return NoVector;
    }

    private static string WrongVector(JsonValue value, string what)
    {
        if (value.Kind != JsonTokenType.StartArray) return $" must be {what}, but is {value.InWords}";
        var elements = value.Content.ToArray();
        return $" must be {what}, but has {elements.Length} element{(elements.Length == 1 ? "" : "s")}{DecimalComma(elements)}";
    }

    /// <summary>A colour like <c>"#ff8800"</c>; null and a problem where it is none.</summary>
    private Color? HexColorAt(JsonValue value, string key)
    {
        var text = value.Text;
        if (text.Length == 7 && text[0] == '#' && uint.TryParse(text.AsSpan(1), NumberStyles.AllowHexSpecifier, null, out var rgb))
            return new((rgb >> 16) / 255.0, (rgb >> 8 & 255) / 255.0, (rgb & 255) / 255.0);
        Report(value, key, $" must be {WhatColorsAre}, but is {value.InWords}; # and six hexadecimal digits make a colour");
        return null;
    }

    private void WarnOfBytes(string key, Vector3 color) => Warn(key, $" is {color}; 0 to 255? Colours here are 0 to 1, and 1 is full intensity");

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

        static bool IsWhole(JsonValue value) => value.Kind == JsonTokenType.Number && !value.AsWritten.AsSpan().ContainsAny('.', 'e', 'E');
    }

    private JsonValue? Place(string key, int? element)
    {
        if (document is null || json.Find(key) is not { } value) return null;
        return element is { } i && value.Kind == JsonTokenType.StartArray ? value.Content.ElementAt(i) : value;
    }

    /// <summary>Notes an error in the value of a key, or in an element of it.</summary>
    private void Report(JsonValue value, string key, string message, int? element = null) => Report(true, value, PathOf(key, element), message);

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
