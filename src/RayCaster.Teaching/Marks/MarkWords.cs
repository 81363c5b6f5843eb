namespace RayCaster.Teaching;

/// <summary>What students are told of their marks.</summary>
internal static class MarkWords
{
    /// <summary>What is to be seen of what cost an item, without saying what is wrong.</summary>
    public static string Symptoms(ItemMarks item) => string.Join(" ", item.Because.Select(Symptom));

    /// <summary>What is to be seen of a mistake, or what is not drawn yet.</summary>
    public static string Symptom(string because) => MistakeCatalog.Named(because)?.Hint.Symptom ?? NotDrawn(because);

    /// <summary>What to ask oneself; empty for what is not drawn yet.</summary>
    public static string Question(string because) => MistakeCatalog.Named(because)?.Hint.Question ?? "";

    /// <summary>A part that is missing, in words.</summary>
    public static string NotDrawn(string part) => part switch
    {
        "attenuation" => "Not written yet: colours do not fade with the distance.",
        "clipping" => "Not written yet: zNear and zFar cut nothing.",
        "aabb" => "Not drawn yet: boxes.",
        "mesh" => "Not drawn yet: meshes.",
        _ => $"Not drawn yet: {part}s.",
    };

    /// <summary>What a verdict means for a student.</summary>
    public static string InWords(this SceneVerdict verdict) => verdict switch
    {
        SceneVerdict.Right => "right",
        SceneVerdict.Explained => "wrong",
        SceneVerdict.Unexplained => "wrong, and somebody will look at it",
        _ => "not there",
    };
}
