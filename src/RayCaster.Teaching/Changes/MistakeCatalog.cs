namespace RayCaster.Teaching.Changes;

/// <summary>All mistakes that are known by name, in pipeline order.</summary>
public static class MistakeCatalog
{
    private static readonly Dictionary<string, Mistake> byId = MistakeBook.Mistakes.ToDictionary(mistake => mistake.Id);

    /// <summary>All of them; a pair's picture does not depend on it.</summary>
    public static IReadOnlyList<Mistake> All => MistakeBook.Mistakes;

    /// <summary>Those that may change a pixel by more than rounding does.</summary>
    internal static IReadOnlyList<Mistake> Visible { get; } = [.. All.Where(mistake => !mistake.IsWithinRounding)];

    /// <summary>Rays through another sample point of each pixel than the scene's.</summary>
    internal static Change OtherSample { get; } = All.Single(mistake => mistake.IsOtherSample).Usual;

    /// <summary>The mistake of an id; null where there is none.</summary>
    public static Mistake? Named(string id) => byId.GetValueOrDefault(id);

    /// <summary>The mistakes that together draw the same as a program in which a part is missing; none for shapes.</summary>
    public static IEnumerable<Mistake> DrawnWithout(string part) => All.Where(mistake => mistake.MissingPart == part);

    /// <summary>Draws a scene as a program with mistakes does: for exams, and for testing a rubric.</summary>
    /// <param name="mistakes">All its mistakes, each in one of its ways, such as <see cref="Mistake.Usual"/>.</param>
    /// <param name="threads">How many threads draw; one per core if left out.</param>
    /// <returns>The picture; two of the mistakes swap its width and height.</returns>
    /// <exception cref="ArgumentException">Two mistakes are in the same part of a formula.</exception>
    public static Picture Draw(Scene scene, IReadOnlyList<Change> mistakes, int? threads = null) =>
        mistakes.Aggregate((FormulaProgram?)FormulaProgram.Slides, (program, mistake) => program is null ? null : mistake.In(program))
            is { } wrong ? wrong.Draw(scene, threads)
            : throw new ArgumentException("two of these mistakes are in the same part of a formula, so no program has both", nameof(mistakes));
}
