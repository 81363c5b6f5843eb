namespace RayCaster.Teaching;

/// <summary>All mistakes that are known by name, in the order of the way of the data.</summary>
public static class MistakeCatalog
{
    /// <summary>All of them; the order stays, new ones join their stage's end.</summary>
    public static IReadOnlyList<Mistake> All { get; } =
        [.. CameraMistakes.All, .. HitMistakes.All, .. ShapeMistakes.All, .. ColorMistakes.All, .. FileMistakes.All];

    /// <summary>The mistake of an id; null where there is none.</summary>
    public static Mistake? Named(string id)
    {
        foreach (var mistake in All)
        {
            if (mistake.Id == id) return mistake;
        }
        return null;
    }
}
