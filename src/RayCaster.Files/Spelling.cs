namespace RayCaster.Files;

/// <summary>Finds the right word for a misspelt one.</summary>
internal static class Spelling
{
    /// <summary>The words of other programs, and of British English, for words of the scene file.</summary>
    private static readonly ILookup<string, string> synonyms = new (string Ours, string Others)[]
    {
        ("position", "eye from origin location pos lookfrom look_from viewpoint camera_position eyepos"),
        ("target", "lookat look_at look view interest focus at to center direction"),
        ("up", "vup upvector up_vector view_up updir"),
        ("width", "image_width imagewidth xres xresolution columns w"),
        ("height", "image_height imageheight yres yresolution rows h"),
        ("fovY", "fov vfov yfov fov_y field_of_view vertical_fov fieldofview angle"),
        ("zNear", "near near_clip clip_near hither"),
        ("zFar", "far far_clip clip_far yon"),
        ("bias", "epsilon"),
        ("radius", "r"),
        ("center", "c position centre middle"),
        ("normal", "n"),
        ("point", "p q position"),
        ("translate", "position translation"),
        ("rotate", "rotation"),
        ("color", "albedo diffuse diffusecolor kd rgb material colour"),
        ("min", "lower pmin"),
        ("max", "upper pmax"),
        ("a", "p0 v0"),
        ("b", "p1 v1"),
        ("c", "p2 v2"),
        ("scale", "size"),
        ("file", "path filename"),
        ("type", "kind"),
        ("name", "id"),
        ("models", "objects shapes primitives world geometry"),
        ("background", "backgroundcolor background_color bg sky"),
        ("aabb", "box cube cuboid"),
        ("sphere", "ball"),
        ("circle", "disc disk"),
        ("triangle", "tri"),
        ("mesh", "obj"),
    }.SelectMany(line => line.Others.Split(' '), (line, other) => (other, line.Ours))
        .ToLookup(pair => pair.other, pair => pair.Ours, StringComparer.OrdinalIgnoreCase);

    /// <summary>The most likely right word, or null.</summary>
    /// <remarks>
    /// First the same word in another case, then a synonym, then the only word that contains it (four letters at least), then the word with the
    /// fewest letters missing, added, wrong or swapped (Damerau–Levenshtein distance): at most one in a word of up to four letters, two in one of
    /// up to eight, else three.
    /// </remarks>
    public static string? Nearest(string word, IEnumerable<string> known)
    {
        if (known.FirstOrDefault(candidate => candidate.Equals(word, StringComparison.OrdinalIgnoreCase)) is { } same) return same;
        if (synonyms[word].FirstOrDefault(known.Contains) is { } synonym) return synonym;

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
