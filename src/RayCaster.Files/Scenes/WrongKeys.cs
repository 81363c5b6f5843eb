namespace RayCaster.Files;

/// <summary>Refuses the keys of an object that are repeated or unknown.</summary>
internal readonly struct WrongKeys(SceneObject o, SceneDocument document)
{
    /// <summary>Refuses each key that the object has already, the first one counts; and each that is not among the known ones.</summary>
    public void Refuse(IEnumerable<JsonValue> keys, List<string> known)
    {
        var places = new Dictionary<string, JsonValue>(); // each key once, though it may be there twice
        foreach (var key in keys)
        {
            if (document.HasTooManyErrors) return;
            if (!places.TryAdd(key.Text, key))
                o.Report(true, key, Shown(key.Text), $" is given twice; the first is in line {document.Text.LineOf(places[key.Text].Start)}");
        }
        var free = known.FindAll(name => !places.ContainsKey(name)); // once for all unknown keys: there may be millions
        foreach (var (name, key) in places)
        {
            if (document.HasTooManyErrors) return;
            if (!known.Contains(name)) o.Report(true, key, Shown(name), " is an unknown key" + Hint(name, known, free, places));
        }
    }

    /// <summary>Which key was probably meant: one that is missing, or else one that is there already.</summary>
    private string Hint(string wrong, List<string> known, List<string> free, Dictionary<string, JsonValue> places)
    {
        if (Spelling.DidYouMean(wrong, free) is { Length: > 0 } help) return help;
        if (Spelling.Nearest(wrong, known) is { } near && places.TryGetValue(near, out var there))
            return $"; \"{near}\" is already there, in line {document.Text.LineOf(there.Start)}";
        return free.Count is > 0 and <= 8 ? $"; keys that can be added here: {string.Join(", ", free)}" : "";
    }

    /// <summary>A key of any length and content, fit for a message.</summary>
    private static string Shown(string key) => PrintableText.Escaped(key.Length > 60 ? key[..60] + "…" : key);
}
