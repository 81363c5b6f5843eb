namespace RayCaster.Teaching;

/// <summary>A program with mistakes, and how near its picture is to a given one.</summary>
/// <param name="Base">What the program does not do yet.</param>
/// <param name="OtherSample">Whether rays pass through the other sample point of each pixel.</param>
internal sealed record WrongProgram(Unfinished Base, IReadOnlyList<Mistake> Variants, bool OtherSample, Misfit Misfit = default)
{
    /// <summary>Rays through the other sample point of each pixel, as a mistake.</summary>
    public static readonly Mistake Center = MistakeCatalog.Named("center")!;

    /// <summary>The bits of its explanation.</summary>
    public double Total { get; init; }

    /// <summary>Equal for candidates that differ only in variants and samples.</summary>
    public string Id => string.Join(' ', Base.NotYet.Concat(Variants.Select(variant => variant.Id)).Order(StringComparer.Ordinal));

    /// <summary>Its mistakes; rays through the other sample point of each pixel are one.</summary>
    public IEnumerable<Mistake> Mistakes => Variants.Concat(OtherSample ? [Center] : []);

    public IEnumerable<string> MistakeIds => Mistakes.Select(mistake => mistake.Id);

    /// <summary>How many parts are missing, and how many mistakes there are.</summary>
    public (int Missing, int Mistakes) Parts => (Base.NotYet.Count, MistakeIds.Count());

    /// <summary>The same without one of its mistakes, or without one of its missing parts; not measured yet.</summary>
    public IEnumerable<WrongProgram> Less =>
    [
        .. Base.NotYet.Select(part => this with { Base = new([.. Base.NotYet.Where(other => other != part)]) }),
        .. Variants.Select((_, i) => this with { Variants = [.. Variants.Where((_, k) => k != i)] }),
    ];

    /// <summary>How many of its mistakes are not in their usual variant, the first.</summary>
    public int Unusual => Variants.Count(variant => variant.Place is null && variant != MistakeCatalog.Named(variant.Id));

    /// <summary>As many triangles as a ray may try one by one; with more a mistake is not tried at all. Beside another mistake it is less: there are
    /// thousands of pairs.</summary>
    public const int MaxTriangles = 20_000, MaxTrianglesBeside = 1000;

    /// <summary>Its formulas for a scene.</summary>
    /// <returns>Null if two of its mistakes are in the same part of a formula.</returns>
    public FormulaProgram? For(Scene scene) =>
        (FormulaProgram.For(scene.Camera) with { LeftOut = [.. Base.Kinds] }).With(Base.AsMistakes.Concat(Mistakes));

    /// <summary>The whole picture of a scene.</summary>
    /// <exception cref="InvalidOperationException">Two of its mistakes are in the same part of a formula.</exception>
    public Picture Draw(Scene scene) =>
        (For(scene) ?? throw new InvalidOperationException("two mistakes in the same part of a formula")).Draw(scene);

    public IReadOnlyList<Mistake> Named => [.. Variants, .. Base.Kinds.Any() ? [] : Base.AsMistakes];
}
