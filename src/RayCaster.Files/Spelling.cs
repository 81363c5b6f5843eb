namespace RayCaster.Files;

/// <summary>Finds the right word for a misspelt one.</summary>
public static class Spelling
{
    /// <summary>The words of other programs, and of British English, for words of the scene file.</summary>
    private static readonly (string Other, string Ours)[] Synonyms =
    [
        .. Of("position", "eye from origin location pos lookfrom look_from viewpoint camera_position eyepos"),
        .. Of("target", "lookat look_at look view interest focus at to center direction"),
        .. Of("up", "vup upvector up_vector view_up updir"),
        .. Of("width", "image_width imagewidth xres xresolution columns w"),
        .. Of("height", "image_height imageheight yres yresolution rows h"),
        .. Of("fovY", "fov vfov yfov fov_y field_of_view vertical_fov fieldofview angle"),
        .. Of("zNear", "near near_clip clip_near hither"),
        .. Of("zFar", "far far_clip clip_far yon"),
        .. Of("bias", "epsilon"),
        .. Of("radius", "r"),
        .. Of("center", "c position centre middle"),
        .. Of("normal", "n"),
        .. Of("point", "p q position"),
        .. Of("translate", "position translation"),
        .. Of("rotate", "rotation"),
        .. Of("color", "albedo diffuse diffusecolor kd rgb material colour"),
        .. Of("min", "lower pmin"),
        .. Of("max", "upper pmax"),
        .. Of("a", "p0 v0"),
        .. Of("b", "p1 v1"),
        .. Of("c", "p2 v2"),
        .. Of("scale", "size"),
        .. Of("file", "path filename"),
        .. Of("type", "kind"),
        .. Of("name", "id"),
        .. Of("models", "objects shapes primitives world geometry"),
        .. Of("background", "backgroundcolor background_color bg sky"),
        .. Of("aabb", "box cube cuboid"),
        .. Of("sphere", "ball"),
        .. Of("circle", "disc disk"),
        .. Of("triangle", "tri"),
        .. Of("mesh", "obj"),
    ];

    private static IEnumerable<(string, string)> Of(string ours, string others) => others.Split(' ').Select(other => (other, ours));

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
