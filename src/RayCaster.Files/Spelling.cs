namespace RayCaster.Files;

/// <summary>Finds the right word for a misspelt one.</summary>
public static class Spelling
{
    /// <summary>The words of other programs, and of British English, for words of the scene file.</summary>
    private static readonly (string Other, string Ours)[] Synonyms =
    [
        ("eye", "position"), ("from", "position"), ("origin", "position"), ("location", "position"), ("pos", "position"),
        ("lookfrom", "position"), ("look_from", "position"), ("viewpoint", "position"), ("camera_position", "position"), ("eyepos", "position"),
        ("lookat", "target"), ("look_at", "target"), ("look", "target"), ("view", "target"), ("interest", "target"), ("focus", "target"), ("at", "target"), ("to", "target"), ("center", "target"), ("direction", "target"),
        ("vup", "up"), ("upvector", "up"), ("up_vector", "up"), ("view_up", "up"), ("updir", "up"),
        ("image_width", "width"), ("imagewidth", "width"), ("xres", "width"), ("xresolution", "width"), ("columns", "width"), ("w", "width"),
        ("image_height", "height"), ("imageheight", "height"), ("yres", "height"), ("yresolution", "height"), ("rows", "height"), ("h", "height"),
        ("fov", "fovY"), ("vfov", "fovY"), ("yfov", "fovY"), ("fov_y", "fovY"), ("field_of_view", "fovY"), ("vertical_fov", "fovY"), ("fieldofview", "fovY"), ("angle", "fovY"), ("near", "zNear"), ("far", "zFar"),
        ("near_clip", "zNear"), ("far_clip", "zFar"), ("clip_near", "zNear"), ("clip_far", "zFar"), ("hither", "zNear"), ("yon", "zFar"), ("epsilon", "bias"),
        ("r", "radius"), ("c", "center"), ("position", "center"), ("centre", "center"), ("n", "normal"), ("p", "point"), ("q", "point"),
        ("position", "point"), ("position", "translate"), ("rotation", "rotate"), ("translation", "translate"),
        ("albedo", "color"), ("diffuse", "color"), ("diffusecolor", "color"), ("kd", "color"), ("rgb", "color"), ("material", "color"),
        ("lower", "min"), ("upper", "max"), ("pmin", "min"), ("pmax", "max"), ("p0", "a"), ("p1", "b"), ("p2", "c"), ("v0", "a"), ("v1", "b"), ("v2", "c"), ("size", "scale"),
        ("path", "file"), ("filename", "file"), ("kind", "type"), ("id", "name"),
        ("objects", "models"), ("shapes", "models"), ("primitives", "models"), ("world", "models"), ("geometry", "models"), ("colour", "color"), ("backgroundcolor", "background"), ("background_color", "background"), ("bg", "background"), ("sky", "background"),
        ("box", "aabb"), ("cube", "aabb"), ("cuboid", "aabb"), ("ball", "sphere"), ("disc", "circle"), ("disk", "circle"), ("tri", "triangle"),
        ("obj", "mesh"), ("middle", "center"),
    ];

    /// <summary>The most likely right word, or null.</summary>
    /// <remarks>
    /// First the same word in another case, then a synonym, then the only word that contains it (four letters at least), then the word with the
    /// fewest letters missing, added, wrong or swapped (Damerau–Levenshtein distance): at most one in a word of up to four letters, two in one of
    /// up to eight, else three.
    /// </remarks>
    public static string? Nearest(string word, IEnumerable<string> known)
    {
        if (known.FirstOrDefault(candidate => candidate.Equals(word, StringComparison.OrdinalIgnoreCase)) is { } same) return same;
        foreach (var (other, ours) in Synonyms)
            if (other.Equals(word, StringComparison.OrdinalIgnoreCase) && known.Contains(ours)) return ours;

        if (word.Length >= 4 && known.Where(longer => longer.Contains(word, StringComparison.OrdinalIgnoreCase)).Take(2).ToArray() is [var only])
            return only;

        var least = word.Length switch { <= 1 => 0, <= 4 => 1, <= 8 => 2, _ => 3 } + 1;
        string? nearest = null;
        int[,]? table = null; // one for all candidates: a file may have a thousand errors
        foreach (var candidate in known)
        {
            if (Math.Abs(candidate.Length - word.Length) >= least) continue;
            table ??= new int[word.Length + 1, word.Length + least];
            var mistakes = Mistakes(word, candidate, table);
            if (mistakes < least) (nearest, least) = (candidate, mistakes);
        }
        return nearest;
    }

    /// <summary>"; did you mean …?" for the end of a message, or an empty text.</summary>
    /// <inheritdoc cref="Nearest"/>
    public static string DidYouMean(string word, IEnumerable<string> known, char quote = '"')
    {
        if (Nearest(word, known) is not { } nearest) return "";
        return $"; did you mean {quote}{nearest}{quote}?" + (nearest.Equals(word, StringComparison.OrdinalIgnoreCase) ? " (case matters)" : "");
    }

    /// <summary>How many letters must be added, left out, changed or swapped with their neighbour; case is ignored.</summary>
    private static int Mistakes(string a, string b, int[,] mistakes)
    {
        for (var i = 0; i <= a.Length; i++) mistakes[i, 0] = i;
        for (var j = 0; j <= b.Length; j++) mistakes[0, j] = j;
        for (var i = 1; i <= a.Length; i++)
        {
            for (var j = 1; j <= b.Length; j++)
            {
                var change = Same(a[i - 1], b[j - 1]) ? 0 : 1;
                mistakes[i, j] = Math.Min(mistakes[i - 1, j - 1] + change, Math.Min(mistakes[i - 1, j], mistakes[i, j - 1]) + 1);
                if (i > 1 && j > 1 && Same(a[i - 1], b[j - 2]) && Same(a[i - 2], b[j - 1]))
                    mistakes[i, j] = Math.Min(mistakes[i, j], mistakes[i - 2, j - 2] + 1);
            }
        }
        return mistakes[a.Length, b.Length];

        static bool Same(char x, char y) => char.ToLowerInvariant(x) == char.ToLowerInvariant(y);
    }
}
