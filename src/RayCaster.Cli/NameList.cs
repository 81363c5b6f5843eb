namespace RayCaster.Cli;

/// <summary>Names on the command line, joined by a sign: as "plane,sphere" or "rows+bgr".</summary>
internal static class NameList
{
    /// <summary>Kinds of shape as a scene file calls them.</summary>
    public static readonly string[] Shapes = ["plane", "sphere", "aabb", "circle", "triangle", "mesh"];

    /// <summary>Takes the names apart.</summary>
    /// <param name="text">What is given.</param>
    /// <param name="separator">What stands between two names.</param>
    /// <param name="known">The names there are.</param>
    /// <param name="what">What a name is, for messages: "a mistake".</param>
    /// <exception cref="ProblemException">A name is not known.</exception>
    public static string[] Of(string text, char separator, IReadOnlyList<string> known, string what)
    {
        var names = text.Split(separator, StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        if (names.Length == 0) throw ProblemException.Usage($"the name of {what} is missing");
        foreach (var name in names)
        {
            if (known.Contains(name)) continue;
            throw ProblemException.Usage($"'{name}' is not {what}; " + (Spelling.Nearest(name, known) is { } nearest
                ? $"did you mean '{nearest}'?"
                : known.Count < 10 ? $"choose {string.Join(", ", known)}" : "docs/mistakes.md lists them all"));
        }
        return [.. names.Distinct()];
    }
}
