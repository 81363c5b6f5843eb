namespace RayCaster.Marks;

internal static class MarkWords
{
    /// <summary>What one sees of a mistake, if the pictures certainly show it, or what is not drawn yet.</summary>
    public static string Symptom(string because, IReadOnlyList<string> typical) =>
        MistakeCatalog.Named(because) is not { } mistake ? NotWritten(because) : typical.Contains(because) ? mistake.Hint.Symptom : "";

    /// <summary>The question that leads to a mistake; for a missing shape the question of a mistake that hides it, or an empty text.</summary>
    public static string Question(string because, IReadOnlyList<string> hiding) => MistakeCatalog.Named(because)?.Hint.Question
        ?? (hiding.Select(id => MistakeCatalog.Named(id)!)
                .FirstOrDefault(mistake => mistake.Usual.IsOnlyOf(because)) is { } mistake
            ? $"If they are written: {mistake.Hint.Question}" : "");

    public static string NotWritten(string part) => part == MissingPart.Attenuation
        ? $"{NotSeen(part)}: attenuation is not written yet, or a mistake hides it."
        : $"{NotSeen(part)}: they are not written yet, or a mistake hides them.";

    /// <summary>What a picture without a part looks like.</summary>
    public static string NotSeen(string part) => part switch
    {
        MissingPart.Attenuation => "Colours do not get darker with the distance",
        MissingPart.Clipping => "zNear and zFar cut nothing",
        _ => $"No {MissingPart.Many(part)} are drawn",
    };

    /// <summary>A verdict in words for the student.</summary>
    public static string InWords(this SceneVerdict verdict) => verdict switch
    {
        SceneVerdict.Right => "right",
        SceneVerdict.Explained => "wrong",
        SceneVerdict.Unexplained => "wrong; your teacher will look at it",
        _ => "no picture",
    };
}
