namespace RayCaster.Teaching;

/// <summary>A program with mistakes, and how near its picture is to a given one.</summary>
/// <param name="Base">What the program does not do yet.</param>
/// <param name="OtherSample">Whether rays pass through the other sample point of each pixel.</param>
internal sealed record WrongProgram(Unfinished Base, IReadOnlyList<Mistake> Variants, bool OtherSample, Misfit Misfit = default)
{
    /// <summary>The factor by which each mistake makes a program costlier.</summary>
    private const double PerMistake = 1 / 0.6;

    /// <summary>The factor for an edit of a formula that is not in the catalogue.</summary>
    private const double Unknown = 1.5;

    /// <summary>Rays through the other sample point of each pixel, as a mistake.</summary>
    public static readonly Mistake Center = MistakeCatalog.Named("center")!;

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
        .. Base.NotYet.Select(part => (this with { Base = new([.. Base.NotYet.Where(other => other != part)]) }).Canonical),
        .. Variants.Select((_, i) => this with { Variants = [.. Variants.Where((_, k) => k != i)] }),
    ];

    /// <summary>The same with rays through the other sample point of each pixel as a mistake only if nothing else is wrong.</summary>
    public WrongProgram Canonical => this switch
    {
        { OtherSample: true, Variants: [], Base.NotYet: [] } => this with { Variants = [Center], OtherSample = false },
        { Variants.Count: > 1 } when Variants.Contains(Center) => this with { Variants = [.. Variants.Except([Center])], OtherSample = true },
        _ => this,
    };

    /// <summary>The same with one of its mistakes in another variant; not measured yet.</summary>
    public WrongProgram With(int place, Mistake variant) =>
        this with { Variants = [.. Variants.Select((own, i) => i == place ? variant : own)] };

    /// <summary>How many of its mistakes are not in their usual variant, the first.</summary>
    public int Unusual => Variants.Count(variant => variant.Place is null && variant != MistakeCatalog.Named(variant.Id));

    /// <summary>As many triangles as a ray may try one by one; with more a mistake is not tried at all. Beside another mistake it is less: there are
    /// thousands of pairs.</summary>
    public const int MaxTriangles = 20_000, MaxTrianglesBeside = 1000;

    /// <summary>Its formulas for a scene.</summary>
    /// <returns>Null if two of its mistakes are in the same part of a formula, or if it takes too long to draw.</returns>
    public FormulaProgram? For(Scene scene) => ProgramOf(scene) is { } program
        && program.TrianglesTried(scene) <= (Variants.Count > 1 ? MaxTrianglesBeside : MaxTriangles) ? program : null;

    /// <summary>The whole picture of a scene, however long it takes.</summary>
    /// <exception cref="InvalidOperationException">Two of its mistakes are in the same part of a formula.</exception>
    public Picture Draw(Scene scene) =>
        (ProgramOf(scene) ?? throw new InvalidOperationException("two mistakes in the same part of a formula")).Draw(scene);

    private FormulaProgram? ProgramOf(Scene scene) =>
        (FormulaProgram.For(scene.Camera) with { LeftOut = [.. Base.Kinds] }).With(Base.AsMistakes.Concat(Mistakes));

    public IReadOnlyList<Mistake> Named => [.. Variants, .. Base.Kinds.Any() ? [] : Base.AsMistakes];

    /// <summary>
    /// What it leaves unexplained, with a factor for what it assumes: two mistakes explain any picture better than one, and a part that is not
    /// written yet is the simplest assumption.
    /// </summary>
    /// <param name="wrong">All that is wrong, as <see cref="Misfit"/> counts it.</param>
    /// <param name="rounding">How much of it another program's rounding may leave: what is left below that says little.</param>
    public double Cost(double wrong, double rounding) =>
        (Misfit.Weight + rounding * wrong)
        * Math.Pow(PerMistake, Variants.Count + (OtherSample ? 0.5 : 0)) * Math.Pow(1.15, Base.NotYet.Count)
        * Math.Pow(Unknown, Variants.Count(variant => variant.Place is not null));

    /// <summary>What may be left so that no program with one more mistake costs less.</summary>
    public double LeastLeft(double wrong, double rounding) => rounding * wrong * (Math.Pow(PerMistake, OtherSample ? 0.5 : 1) - 1);
}
