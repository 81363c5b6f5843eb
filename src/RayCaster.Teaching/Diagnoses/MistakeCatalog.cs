namespace RayCaster.Teaching;

/// <summary>All mistakes that are known by name, in pipeline order.</summary>
public static class MistakeCatalog
{
    /// <summary>All of them; a pair's picture does not depend on it.</summary>
    public static IReadOnlyList<Mistake> All { get; } =
    [
        .. AxisMistakes.All, .. ImagePlaneMistakes.All, .. PixelMistakes.All, .. VectorMistakes.All, .. HitMistakes.All, .. SphereMistakes.All,
        .. SurfaceMistakes.All, .. OriginMistakes.All, .. BoxMistakes.All, .. ColorMistakes.All, .. FileMistakes.All,
    ];

    private static readonly Dictionary<string, Mistake> byId = All.ToDictionary(mistake => mistake.Id);

    /// <summary>The mistake of an id; null where there is none.</summary>
    public static Mistake? Named(string id) => byId.GetValueOrDefault(id);

    /// <summary>Draws a scene as a program with mistakes does: for exams, and for testing a rubric.</summary>
    /// <param name="mistakes">All its mistakes; each is one of the catalogue, or one of its variants.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <returns>The picture; two of the mistakes swap its width and height.</returns>
    public static Picture Draw(Scene scene, IReadOnlyList<Mistake> mistakes, int? threads = null) => new Lab(scene, [.. mistakes]).Render(threads);
}
