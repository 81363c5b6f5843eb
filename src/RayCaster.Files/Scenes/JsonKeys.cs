using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>
/// An object of a scene file. Each call reads one key. A wrong value is reported with its place, and the call returns NaN; every comparison with
/// NaN is false, so rules that compare values report nothing more.
/// </summary>
/// <remarks>
/// The same calls describe the keys: <see cref="Describing"/> makes an object without any, which collects those that are looked for. The editors'
/// schema is made from these, so it cannot differ from the reader.
/// </remarks>
internal sealed class JsonKeys(JsonValue json, List<KeySpec>? described = null)
{
    private const double ShortestDirection = 1e-200, LongestDirection = 1e200;

    private readonly SceneReading reading = json.Reading;
    private readonly string path = json.Path;
    private readonly int errorsBefore = json.Reading.ErrorCount;
    private readonly List<string> keysRead = [];
    private int found; // how many of the keys that were read are there

    public SceneReading Reading => reading;

    public bool IsSound => reading.ErrorCount == errorsBefore;

    /// <summary>An object without keys that collects those that are read. Nobody sees what it reports.</summary>
    public static JsonKeys Describing(out IReadOnlyList<KeySpec> keys)
    {
        var described = new List<KeySpec>();
        keys = described;
        return new(JsonTree.Parse(new("", "{}"u8.ToArray(), ""))!.Root, described);
    }

    /// <summary>The value as an object; null, after a report, if it is something else.</summary>
    /// <param name="name">What a message calls it, if not by its path.</param>
    public static JsonKeys? AsObject(JsonValue value, string? name = null)
    {
        if (value.Kind == JsonTokenType.StartObject) return new(value);
        value.Reading.Add(true, value.Start, value.End, $"{name ?? value.Path} must be an object in braces {{ }}, but is {value.InWords}");
        return null;
    }

    public bool Has(string key) => json.Find(key) is not null;

    public string PathOf(string key, int? element = null) => (path.Length > 0 ? path + "." + key : key) + (element is { } i ? $"[{i}]" : "");

    public double Number(string key, string meaning, Limits limits, double? orElse = null) =>
        Take(new(key, KeyKind.Number, meaning, orElse is null, orElse) { Limits = limits })?.Limited(limits) ?? orElse ?? double.NaN;

    public double Radius(string key, string meaning)
    {
        var radius = Number(key, meaning, Limits.Positive);
        if (radius > Limits.Coordinate.Most) Refuse(key, $" must be at most 1e100, but is {Place(key, null)?.AsWritten}");
        return radius;
    }

    /// <summary>A whole number from <paramref name="least"/> to <paramref name="most"/>; the default in place of an erroneous one.</summary>
    public int Whole(string key, string meaning, int least, int most, int orElse)
    {
        var limits = Limits.From(least, most);
        var number = Take(new(key, KeyKind.Whole, meaning, false, orElse) { Limits = limits })?.Whole(limits) ?? orElse;
        return double.IsNaN(number) ? orElse : (int)number;
    }

    public Vector3 Vector(string key, string meaning, Vector3? orElse = null) => Vector(key, KeyKind.Vector, meaning, Limits.Coordinate, orElse);

    public Vector3 Direction(string key, string meaning, Vector3? orElse = null)
    {
        var direction = Vector(key, KeyKind.Direction, meaning, Limits.None, orElse);
        var length = direction.Length;
        if (length == 0) Refuse(key, $" must not be {Place(key, null)?.AsWritten}, which has no direction");
        else if (length is < ShortestDirection or > LongestDirection) // products with coordinates leave the range of a double
            Refuse(key, $" must have a length from {ShortestDirection} to {LongestDirection}, but is {Place(key, null)?.AsWritten}");
        else return direction;
        return JsonValue.NoVector;
    }

    public Vector3[] Vectors(string key, string meaning) =>
        [.. Elements(new(key, KeyKind.Vectors, meaning, false), "vectors").Select(vector => vector.Vector(Limits.None))];

    /// <summary>An array of faces, each an array of at least three indices: three for each triangle, where polygons are split as a fan.</summary>
    /// <param name="vertices">The indices are places in these; any indices if there are none.</param>
    public int[] Faces(string key, string meaning, Vector3[] vertices)
    {
        var triangles = new List<int>();
        var limits = Limits.From(0, vertices.Length > 0 ? vertices.Length - 1 : int.MaxValue);
        foreach (var face in Elements(new(key, KeyKind.Faces, meaning, false), "faces"))
        {
            var before = triangles.Count;
            face.AddTriangles(limits, triangles);
            if (!IsSound || vertices.Length == 0 || triangles.Count <= before + 3) continue;
            if (Fan.IsFolded(CollectionsMarshal.AsSpan(triangles)[before..], vertices)) face.Report(false, " " + Fan.Warning);
        }
        return [.. triangles];
    }

    /// <summary>A factor for each axis, or one for all; none of them 0.</summary>
    public Vector3 Factors(string key, string meaning, double orElse)
    {
        var factor = orElse;
        if (Take(new(key, KeyKind.Factors, meaning, false, orElse)) is { } value)
        {
            if (value.Kind != JsonTokenType.Number) return value.Vector(Limits.NotZero, "a number or " + JsonValue.VectorForm);
            factor = value.Limited(Limits.NotZero);
        }
        return new(factor, factor, factor);
    }

    public Color Color(string key, string meaning, Color orElse) => Take(new(key, KeyKind.Color, meaning, false, orElse))?.Color() ?? orElse;

    /// <summary>A text; null where it is left out or something else. A required one must not be empty.</summary>
    public string? Text(string key, string meaning, bool isRequired)
    {
        if (Take(new(key, KeyKind.Text, meaning, isRequired)) is not { } value || !value.IsText()) return null;
        if (!isRequired || value.Text.Length > 0) return value.Text;
        Refuse(key, $" must not be empty");
        return null;
    }

    public string? FileName(string key, string meaning) =>
        Take(new(key, KeyKind.FileName, meaning, false)) is { } value && value.IsFileName() ? value.Text : null;

    /// <summary>An array of texts, which may name files; empty where it is left out. Elements that are something else are reported and left
    /// out.</summary>
    public IReadOnlyList<string> Texts(string key, string meaning, bool isRequired) =>
        [.. Elements(new(key, KeyKind.Texts, meaning, isRequired), "texts").Where(value => value.IsFileName()).Select(value => value.Text)];

    /// <summary>One of several words, or null; it must be there if <paramref name="orElse"/> is null.</summary>
    public string? Choice(string key, string meaning, string? orElse, string[] words) =>
        Take(new(key, KeyKind.Choice, meaning, orElse is null, orElse) { Choices = words })?.OneOf(words);

    public string OptionalChoice(string key, string meaning, params string[] words) => Choice(key, meaning, words[0], words) ?? words[0];

    public JsonKeys? Object(string key, string meaning)
    {
        if (described is null) return Take(new(key, KeyKind.Object, meaning, true)) is { } value ? AsObject(value) : null;
        var describing = Describing(out var members);
        described.Add(new(key, KeyKind.Object, meaning, true) { Members = members });
        return describing;
    }

    /// <summary>The objects of an array; elements that are something else are reported and left out.</summary>
    public IEnumerable<JsonKeys> Objects(string key, string meaning)
    {
        foreach (var element in Elements(new(key, KeyKind.Objects, meaning, true), "objects"))
            if (AsObject(element) is { } o)
                yield return o;
    }

    /// <summary>Refuses a value that was read, or one of its elements: <paramref name="message"/> follows the path.</summary>
    public void Refuse(string key, FormattableString message, int? element = null) =>
        Report(true, Place(key, element), key, FormattableString.Invariant(message), element);

    public void Warn(string key, FormattableString message) => Report(false, Place(key, null), key, FormattableString.Invariant(message));

    /// <summary>Refuses the keys that were not read, and those that are there twice, of which the first counts.</summary>
    /// <param name="allowed">Keys that are right although they were not read.</param>
    public void Close(params IEnumerable<string> allowed)
    {
        if (2 * found == json.Count) return; // fewer were read if one is unknown or there twice
        keysRead.AddRange(allowed);
        var places = new Dictionary<string, JsonValue>(); // each key once, though it may be there twice
        foreach (var key in json.Keys)
        {
            if (reading.HasTooManyErrors) return;
            if (!places.TryAdd(key.Text, key))
                Report(true, key, Shown(key.Text), $" is given twice; the first is in line {reading.Source.LineOf(places[key.Text].Start)}");
        }
        var free = keysRead.FindAll(name => !places.ContainsKey(name)); // once for all unknown keys: there may be millions
        foreach (var (name, key) in places)
        {
            if (reading.HasTooManyErrors) return;
            if (!keysRead.Contains(name)) Report(true, key, Shown(name), " is an unknown key" + Hint(name, free, places));
        }
    }

    /// <summary>Which key was probably meant: one that is missing, or else one that is there already.</summary>
    private string Hint(string wrong, List<string> free, Dictionary<string, JsonValue> places)
    {
        if (Spelling.DidYouMean(wrong, free) is { Length: > 0 } help) return help;
        if (Spelling.Nearest(wrong, keysRead) is { } near && places.TryGetValue(near, out var there))
            return $"; \"{near}\" is already there, in line {reading.Source.LineOf(there.Start)}";
        return free.Count is > 0 and <= 8 ? $"; keys that can be added here: {string.Join(", ", free)}" : "";
    }

    private static string Shown(string key) => PrintableText.Escaped(key.Length > 60 ? key[..60] + "…" : key);

    /// <summary>Reports a problem at a value; at the object's opening brace where the value is null.</summary>
    private void Report(bool isError, JsonValue? value, string key, string message, int? element = null)
    {
        var (start, end) = value is { } v ? (v.Start, v.End) : (json.Start, json.Start + 1);
        reading.Add(isError, start, end, PathOf(key, element) + message);
    }

    /// <summary>The value of a key, which is read only once. Null if the key is missing, which is an error for a required key.</summary>
    private JsonValue? Take(KeySpec key)
    {
        described?.Add(key);
        keysRead.Add(key.Name);
        if (json.Find(key.Name, PathOf(key.Name)) is { } value)
        {
            found++;
            return value;
        }
        if (key.IsRequired) Report(true, null, key.Name, " is missing: " + (key.Choices.Length > 0 ? JsonValue.Quoted(key.Choices) : key.Meaning));
        return null;
    }

    private Vector3 Vector(string key, KeyKind kind, string meaning, Limits limits, Vector3? orElse) =>
        Take(new(key, kind, meaning, orElse is null, orElse))?.Vector(limits) ?? orElse ?? JsonValue.NoVector;

    private IEnumerable<JsonValue> Elements(KeySpec key, string name) =>
        Take(key) is { } value && value.IsArray(name) ? value.Elements : [];

    private JsonValue? Place(string key, int? element)
    {
        if (json.Find(key) is not { } value) return null;
        return element is { } i && value.Kind == JsonTokenType.StartArray ? value[i] : value;
    }
}
