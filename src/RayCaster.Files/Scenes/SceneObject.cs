using System.Runtime.InteropServices;

namespace RayCaster.Files;

/// <summary>
/// An object of a scene file. Each call reads one key. A wrong value is reported with its place, and the call returns NaN; every comparison with
/// NaN is false, so rules that compare values report nothing more.
/// </summary>
/// <remarks>
/// The same calls describe the keys: an object made by <see cref="Describing"/> has no text, reports nothing, and collects the keys that are
/// read. The editors' schema is made from these, so it cannot differ from the reader.
/// </remarks>
internal sealed class SceneObject
{
    private const string VectorForm = "an array of three numbers [x, y, z]";
    private static readonly Vector3 NoVector = new(double.NaN, double.NaN, double.NaN);

    private readonly string path;
    private readonly List<string> keysRead = [];
    private readonly List<SceneKey>? described;
    private JsonValue json;
    private int? index;        // in the array at that path
    private int errorsBefore;
    private int found; // how many of its keys were read

    /// <param name="path">The object's path, empty for the scene itself; for the elements of an array, the array's path.</param>
    private SceneObject(SceneDocument document, string path) => (Document, this.path) = (document, path);

    private SceneObject(List<SceneKey> described) => (this.described, path) = (described, "");

    /// <summary>The scene file; null where the object is only described.</summary>
    public SceneDocument? Document { get; }

    /// <summary>Whether no error was found in this object so far.</summary>
    public bool IsSound => Document is null || Document.ErrorCount == errorsBefore;

    /// <summary>An object without text that collects the keys that are read.</summary>
    public static SceneObject Describing(out IReadOnlyList<SceneKey> keys)
    {
        var described = new List<SceneKey>();
        keys = described;
        return new(described);
    }

    /// <summary>Begins to read a value as an object; null, after a report, if it is something else.</summary>
    /// <param name="path">Its path, empty for the outermost.</param>
    /// <param name="name">What a message calls it, if not by its path.</param>
    public static SceneObject? AsObject(SceneDocument document, JsonValue value, string path, string? name = null)
    {
        var o = new SceneObject(document, path);
        return o.Begin(value, null, name) ? o : null;
    }

    public bool Has(string key) => Document is not null && json.Find(key) is not null;

    /// <summary>The path of a value, or of an element of a vector, as messages name it: <c>models[3].min[1]</c>.</summary>
    public string PathOf(string key, int? element = null) => (path.Length > 0 ? Path + "." + key : key) + (element is { } i ? $"[{i}]" : "");

    private string Path => index is { } i ? $"{path}[{i}]" : path;

    public double Radius(string key, string meaning)
    {
        var radius = Number(key, meaning, Limits.Positive);
        if (radius > Limits.Coordinate.Most) Refuse(key, $" must be at most 1e100, but is {Place(key, null)?.AsWritten}");
        return radius;
    }

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
        var number = WholeAt(value, key, null, limits);
        return double.IsNaN(number) ? orElse : (int)number;
    }

    public Vector3 Vector(string key, string meaning, Vector3? orElse = null) => Vector(key, KeyKind.Vector, meaning, Limits.Coordinate, orElse);

    /// <summary>An array of vectors; empty where it is left out.</summary>
    public Vector3[] Vectors(string key, string meaning)
    {
        described?.Add(new(key, KeyKind.Vectors, meaning, false));
        return [.. Elements(key, meaning, "vectors").Select((vector, i) => VectorAt(vector, $"{key}[{i}]", Limits.None, VectorForm))];
    }

    /// <summary>An array of faces, each an array of at least three indices: three for each triangle, where polygons are split as a fan.</summary>
    /// <param name="vertices">The indices are places in these; any indices if there are none.</param>
    public int[] Faces(string key, string meaning, Vector3[] vertices)
    {
        described?.Add(new(key, KeyKind.Faces, meaning, false));
        var (i, triangles) = (0, new List<int>());
        var limits = Limits.From(0, vertices.Length > 0 ? vertices.Length - 1 : int.MaxValue);
        foreach (var face in Elements(key, meaning, "faces"))
        {
            var before = triangles.Count;
            AddTriangles(face, $"{key}[{i}]", limits, triangles);
            if (IsSound && vertices.Length > 0 && triangles.Count > before + 3
                && Fan.IsFolded(CollectionsMarshal.AsSpan(triangles)[before..], vertices))
                Report(false, face, $"{key}[{i}]", " " + Fan.Warning);
            i++;
        }
        return [.. triangles];
    }

    /// <summary>A vector of any length but zero.</summary>
    public Vector3 Direction(string key, string meaning, Vector3? orElse = null)
    {
        var direction = Vector(key, KeyKind.Direction, meaning, Limits.None, orElse);
        if (direction.Length != 0) return direction;
        Refuse(key, $" must not be {Place(key, null)?.AsWritten}, which has no direction");
        return NoVector;
    }

    /// <summary>A factor for each axis, or one for all; none of them 0.</summary>
    public Vector3 Factors(string key, string meaning, double orElse)
    {
        described?.Add(new(key, KeyKind.Factors, meaning, false, orElse));
        if (Take(key, meaning, false) is not { } value) return new(orElse, orElse, orElse);
        if (value.Kind != JsonTokenType.Number) return VectorAt(value, key, Limits.NotZero, "a number or " + VectorForm);
        var factor = NumberAt(value, key, null, Limits.NotZero);
        return new(factor, factor, factor);
    }

    /// <summary>A colour: three numbers of at least 0, or a text like <c>"#ff8800"</c>.</summary>
    public Color Color(string key, string meaning, Color orElse)
    {
        described?.Add(new(key, KeyKind.Color, meaning, false, orElse));
        if (Take(key, meaning, false) is not { } value) return orElse;
        if (value.Kind == JsonTokenType.String)
        {
            if (SceneColor.Parse(value.Text) is { } parsed) return parsed;
            Report(true, value, key, $" must be {SceneColor.Form}, but is {value.InWords}; # and six hexadecimal digits make a colour");
            return orElse;
        }
        var color = VectorAt(value, key, Limits.NotNegative, SceneColor.Form);
        if (SceneColor.LooksLikeBytes(color)) Warn(key, $" is {color}; 0 to 255? Colours here are 0 to 1, and 1 is full intensity");
        return new(color.X, color.Y, color.Z);
    }

    /// <summary>True or false; false where it is left out.</summary>
    public bool Flag(string key, string meaning)
    {
        described?.Add(new(key, KeyKind.Flag, meaning, false));
        if (Take(key, meaning, false) is not { } value) return false;
        if (value.Kind is not (JsonTokenType.True or JsonTokenType.False))
            Report(true, value, key, " must be true or false, but is " + value.InWords);
        return value.Kind == JsonTokenType.True;
    }

    /// <summary>A text; null where it is left out or something else. A required one must not be empty.</summary>
    public string? Text(string key, string meaning, bool isRequired) => Text(key, KeyKind.Text, meaning, isRequired)?.Text;

    /// <summary>A text that names a file; null where it is left out or something else.</summary>
    public string? FileName(string key, string meaning, bool isRequired) =>
        Text(key, KeyKind.FileName, meaning, isRequired) is { } name && MayBeName(name, key) ? name.Text : null;

    /// <summary>An array of texts, which may name files; empty where it is left out. Elements that are something else are reported and left
    /// out.</summary>
    public IReadOnlyList<string> Texts(string key, string meaning, bool isRequired)
    {
        described?.Add(new(key, KeyKind.Texts, meaning, isRequired));
        return Take(key, meaning, isRequired) is { } value && IsArray(value, key, "texts")
            ? [.. value.Content.Where((text, i) => IsText(text, key, i) && MayBeName(text, key, i)).Select(text => text.Text)]
            : [];
    }

    /// <summary>One of several words; the first where it is left out.</summary>
    public string OptionalChoice(string key, string meaning, params string[] words) =>
        Choice(key, meaning, words[0], words) ?? words[0];

    /// <summary>An object; null if it is missing, or something else.</summary>
    public SceneObject? Object(string key, string meaning)
    {
        if (described is not null)
        {
            var describing = Describing(out var members);
            described.Add(new(key, KeyKind.Object, meaning, true) { Members = members });
            return describing;
        }
        return Take(key, meaning, true) is { } value ? AsObject(Document!, value, PathOf(key)) : null;
    }

    /// <summary>
    /// The objects of an array; elements that are something else are reported and left out. It is the same <see cref="SceneObject"/> each time,
    /// so that a million of them need no memory: finish with one before you take the next.
    /// </summary>
    public IEnumerable<SceneObject> Objects(string key, string meaning)
    {
        described?.Add(new(key, KeyKind.Objects, meaning, true));
        if (Take(key, meaning, true) is not { } value || !IsArray(value, key, "objects")) yield break;
        var (i, o) = (0, new SceneObject(Document!, PathOf(key)));
        foreach (var element in value.Content)
        {
            if (Document!.HasTooManyErrors) yield break;
            if (o.Begin(element, i++)) yield return o;
        }
    }

    /// <summary>Refuses a value that was read, or one of its elements: <paramref name="message"/> follows the path.</summary>
    public void Refuse(string key, FormattableString message, int? element = null) =>
        Report(true, Place(key, element), key, FormattableString.Invariant(message), element);

    /// <summary>Warns of a value: <paramref name="message"/> follows the path.</summary>
    public void Warn(string key, FormattableString message) => Report(false, Place(key, null), key, FormattableString.Invariant(message));

    /// <summary>Refuses the keys that were not read, and those that are there twice.</summary>
    /// <param name="allowed">Keys that are right although they were not read.</param>
    public void Close(params IEnumerable<string> allowed)
    {
        if (Document is null || found == json.Keys.Count()) return; // fewer were read if one is unknown or there twice
        keysRead.AddRange(allowed);
        new WrongKeys(this, Document).Refuse(json.Keys, keysRead);
    }

    /// <summary>Reports a problem at a value; at the object's opening brace where the value is null.</summary>
    internal void Report(bool isError, JsonValue? value, string key, string message, int? element = null)
    {
        var (start, end) = value is { } v ? (v.Start, v.End) : (json.Start, json.Start + 1);
        Document?.Add(isError, start, end, PathOf(key, element) + message);
    }

    /// <summary>Begins to read a value as an object; false, after a report, if it is something else.</summary>
    /// <param name="name">What a message calls it, if not by its path.</param>
    private bool Begin(JsonValue value, int? position, string? name = null)
    {
        (json, index, errorsBefore, found) = (value, position, Document!.ErrorCount, 0);
        keysRead.Clear();
        if (value.Kind == JsonTokenType.StartObject) return true;
        Document.Add(true, json.Start, json.End, $"{name ?? Path} must be an object in braces {{ }}, but is {json.InWords}");
        return false;
    }

    /// <summary>The value of a key, which is read only once. Null if the key is missing, which is an error for a required key.</summary>
    private JsonValue? Take(string key, string meaning, bool isRequired, string[]? words = null)
    {
        if (Document is null) return null;
        keysRead.Add(key);
        var value = json.Find(key);
        if (value is not null) found++;
        else if (isRequired) Report(true, null, key, " is missing: " + (words is null ? meaning : WrongValue.OneOf(words)));
        return value;
    }

    private Vector3 Vector(string key, KeyKind kind, string meaning, Limits limits, Vector3? orElse)
    {
        described?.Add(new(key, kind, meaning, orElse is null, orElse));
        return Take(key, meaning, orElse is null) is { } value ? VectorAt(value, key, limits, VectorForm) : orElse ?? NoVector;
    }

    /// <summary>The elements of an array, until there are too many errors; none where it is left out or something else.</summary>
    private IEnumerable<JsonValue> Elements(string key, string meaning, string name) =>
        Take(key, meaning, false) is { } value && IsArray(value, key, name) ? value.Content.TakeWhile(_ => !Document!.HasTooManyErrors) : [];

    private void AddTriangles(JsonValue face, string path, Limits limits, List<int> triangles)
    {
        if (!IsArray(face, path, "indices")) return;
        var (first, previous, count) = (0, 0, 0);
        foreach (var index in face.Content)
        {
            var corner = (int)WholeAt(index, path, count, limits);
            if (count >= 2) triangles.AddRange([first, previous, corner]);
            (first, previous) = (count == 0 ? corner : first, corner);
            count++;
        }
        if (count < 3) Report(true, face, path, $" must have at least three indices, but has {count}");
    }

    private JsonValue? Text(string key, KeyKind kind, string meaning, bool isRequired)
    {
        described?.Add(new(key, kind, meaning, isRequired));
        if (Take(key, meaning, isRequired) is not { } value || !IsText(value, key)) return null;
        if (!isRequired || value.Text.Length > 0) return value;
        Refuse(key, $" must not be empty");
        return null;
    }

    private bool IsText(JsonValue value, string key, int? element = null)
    {
        if (value.Kind == JsonTokenType.String) return true;
        Report(true, value, key, " must be a text in double quotes, but is " + value.InWords, element);
        return false;
    }

    private bool MayBeName(JsonValue text, string key, int? element = null)
    {
        if (!text.Text.Contains('\0')) return true;
        Report(true, text, key, " must not hold the character U+0000, which no file name has", element);
        return false;
    }

    private bool IsArray(JsonValue value, string key, string elements)
    {
        if (value.Kind == JsonTokenType.StartArray) return true;
        Report(true, value, key, $" must be an array of {elements} in brackets [ ], but is {value.InWords}");
        return false;
    }

    /// <summary>One of several words, or null; it must be there if <paramref name="orElse"/> is null.</summary>
    public string? Choice(string key, string meaning, string? orElse, string[] words)
    {
        described?.Add(new(key, KeyKind.Choice, meaning, orElse is null, orElse) { Choices = words });
        if (Take(key, meaning, orElse is null, words) is not { } value || !IsText(value, key)) return null;
        foreach (var word in words)
            if (value.Is(word))
                return word;
        Report(true, value, key, WrongValue.Word(value, words));
        return Spelling.Nearest(value.Text, words);
    }

    private double NumberAt(JsonValue value, string key, int? element, Limits limits)
    {
        if (value.Kind == JsonTokenType.Number && value.Number is var number && double.IsFinite(number) && limits.Allow(number)) return number;
        Report(true, value, key, WrongValue.Number(value, limits), element);
        return double.NaN;
    }

    private double WholeAt(JsonValue value, string key, int? element, Limits limits)
    {
        if (value.Kind != JsonTokenType.Number || !double.IsFinite(value.Number) || double.IsInteger(value.Number))
            return NumberAt(value, key, element, limits);
        Report(true, value, key, " must be a whole number, but is " + value.AsWritten, element);
        return double.NaN;
    }

    private Vector3 VectorAt(JsonValue value, string key, Limits limits, string form)
    {
        if (value.Kind == JsonTokenType.StartArray && value.Content.Take(4).ToArray() is [var x, var y, var z])
            return new(NumberAt(x, key, 0, limits), NumberAt(y, key, 1, limits), NumberAt(z, key, 2, limits));
        Report(true, value, key, WrongValue.Vector(value, form));
        return NoVector;
    }

    private JsonValue? Place(string key, int? element)
    {
        if (Document is null || json.Find(key) is not { } value) return null;
        return element is { } i && value.Kind == JsonTokenType.StartArray ? value.Content.ElementAt(i) : value;
    }
}
