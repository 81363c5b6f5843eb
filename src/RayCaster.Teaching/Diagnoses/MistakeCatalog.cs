namespace RayCaster.Teaching;

/// <summary>All mistakes that are known by name, in the order of the way of the data.</summary>
public static class MistakeCatalog
{
    /// <summary>All of them; a pair's picture does not depend on it.</summary>
    public static IReadOnlyList<Mistake> All { get; } =
    [
        .. AxisMistakes.All, .. ImagePlaneMistakes.All, .. PixelMistakes.All, .. VectorMistakes.All, .. HitMistakes.All, .. SphereMistakes.All,
        .. SurfaceMistakes.All, .. OriginMistakes.All, .. BoxMistakes.All, .. ColorMistakes.All, .. FileMistakes.All,
    ];

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
