namespace RayCaster.Cli;

/// <summary>Lists of names on the command line, such as "plane,sphere" or "rows+bgr".</summary>
internal static class NameList
{
    /// <param name="what">What a name stands for, in messages: "a mistake".</param>
    /// <exception cref="ProblemException">A name is unknown.</exception>
    public static string[] Of(string text, char separator, IReadOnlyList<string> known, string what)
    {
        var names = text.Split(separator, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (names.Length == 0) throw ProblemException.Usage($"the name of {what} is missing");
        foreach (var name in names)
        {
            if (known.Contains(name)) continue;
            var other = separator == ',' ? '+' : ',';
            if (name.Contains(other)) throw ProblemException.Usage($"'{name}' is not {what}; join names by '{separator}', not by '{other}'");
            throw ProblemException.Usage($"'{name}' is not {what}; " + (Spelling.Nearest(name, known) is { } nearest
                ? $"did you mean '{nearest}'?"
                : known.Count < 10 ? $"choose {string.Join(", ", known)}" : "docs/mistakes.md lists them all"));
        }
        return [.. names.Distinct()];
    }
}
