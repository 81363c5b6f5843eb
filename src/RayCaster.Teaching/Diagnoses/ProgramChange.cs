namespace RayCaster.Teaching;

/// <summary>A change of a program, as a student may have made it.</summary>
/// <param name="Id">Its name; "edit" for a mistake without one, empty for what is no mistake.</param>
/// <param name="Bits">The less, the likelier.</param>
/// <param name="In">A program with it; null if it does not fit.</param>
internal sealed record ProgramChange(string Id, double Bits, Func<FormulaProgram, FormulaProgram?> In)
{
    private static readonly SectionKind[] shapes =
        [SectionKind.Plane, SectionKind.Circle, SectionKind.Sphere, SectionKind.Aabb, SectionKind.Triangle];

    /// <summary>The known mistake, in one of its variants.</summary>
    public Mistake? Mistake { get; init; }

    /// <summary>The edit of a formula that is no variant.</summary>
    public FormulaEdit? Edit { get; init; }

    /// <summary>What is not written yet: a kind of shape, attenuation or clipping.</summary>
    public string? NotYet { get; init; }

    /// <summary>Whether it is named; rays through the other sample point are no mistake beside one.</summary>
    public bool IsMistake => Id != "" && !IsOtherSample;

    public bool IsOtherSample => Mistake == WrongProgram.Center;

    /// <summary>What a program may not do yet.</summary>
    public static IEnumerable<ProgramChange> Missing(IEnumerable<string> parts) =>
        from part in parts
        let unfinished = new Unfinished([part])
        select new ProgramChange("", Priors.NotYet, program => program.LeftOut.Contains(part) ? null
            : (program with { LeftOut = program.LeftOut.Union(unfinished.Kinds) }).With(unfinished.AsMistakes))
        { NotYet = part };

    /// <summary>Known mistakes, each in all its variants.</summary>
    public static IEnumerable<ProgramChange> Of(IEnumerable<Mistake> known, Predicate<Mistake>? likely) =>
        from mistake in known
        from variant in mistake.Variants
        select new ProgramChange(mistake.Id,
            mistake == WrongProgram.Center ? Priors.OtherSample
                : Priors.Known + (variant == mistake ? 0 : Priors.Variant) + (Priors.RareIds.Contains(mistake.Id) ? Priors.Rare : 0)
                    + (likely is null || likely(mistake) ? 0 : Priors.Unlikely),
            variant.In)
        { Mistake = variant };

    /// <summary>Further wordings of known mistakes.</summary>
    public static IEnumerable<ProgramChange> Wordings(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from section in SectionsOf(scene)
        from edit in EditFactory.NamedEditsOf(section)
        where known.Any(mistake => mistake.Id == edit.Label)
        select Of(edit);

    /// <summary>The edits of each step that a scene shows, in each style. Those of a mistake that is not among the known ones are left out.
    /// </summary>
    public static IEnumerable<ProgramChange> Edits(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from edit in EditsOf(scene)
        where edit.Label is null || known.Any(mistake => mistake.Id == edit.Label)
        select Of(edit);

    private static ProgramChange Of(FormulaEdit edit) => new(edit.Label ?? EditNaming.Id,
        edit.Label is null ? Priors.Unknown + Priors.PerCost * (edit.Cost - 0.8) : Priors.Known + Priors.Wording * edit.Cost, edit.On)
    {
        Edit = edit,
    };

    /// <summary>Other right styles, which show beside a mistake.</summary>
    public static IEnumerable<ProgramChange> Styles(Scene scene)
    {
        var slides = FormulaProgram.For(scene.Camera);
        return from kind in (SectionKind[])[.. shapes, SectionKind.Rule, SectionKind.Light, SectionKind.Pixel]
               where !shapes.Contains(kind) || scene.Models.Any(model => FormulaEvaluator.KindOf(model) == kind)
               from section in FormulaBook.Slides.StylesOf(kind)
               where section != slides[kind] && IsPossible(section, scene)
               select new ProgramChange("", Priors.Style, program => program[kind] == slides[kind] ? program.With(section) : null);
    }

    /// <summary>The sections that a scene shows, in each style.</summary>
    private static IEnumerable<FormulaSection> SectionsOf(Scene scene)
    {
        var kinds = scene.Models.Select(model => FormulaEvaluator.KindOf(model)).ToHashSet();
        return from kind in Enum.GetValues<SectionKind>()
               where !shapes.Contains(kind) || kinds.Contains(kind)
               from section in FormulaBook.Slides.StylesOf(kind)
               where IsPossible(section, scene)
               select section;
    }

    private static IEnumerable<FormulaEdit> EditsOf(Scene scene)
    {
        foreach (var section in SectionsOf(scene))
        {
            var edits = EditFactory.EditsOf(section);
            foreach (var edit in section.Kind == SectionKind.Plane ? [.. edits, .. shared.Value] : edits)
            {
                yield return edit;
                if (section.Kind == SectionKind.Vectors)
                    yield return edit with { Beside = [FormulaBook.Slides[SectionKind.Light, "doubled"]], Cost = edit.Cost + 0.1 };
                if (section.Kind == SectionKind.Camera && edit.Formula?.Name.Text == "W" && scene.Camera.Clip == ClipMode.Depth)
                    yield return edit with { Beside = [FormulaBook.Slides[SectionKind.Rule, "aim"]], Cost = edit.Cost + 0.1 };
            }
        }
    }

    /// <summary>Slips in the plane's t that circles and triangles share, because it is one method for all of them.</summary>
    private static readonly Lazy<FormulaEdit[]> shared = new(() =>
    [
        .. from edit in EditFactory.EditsOf(FormulaBook.Slides.StylesOf(SectionKind.Plane)[0])
           where edit.Place is not null
           let circle = Alike(edit, FormulaBook.Slides.StylesOf(SectionKind.Circle)[0], "C")
           let triangle = Alike(edit, FormulaBook.Slides[SectionKind.Triangle, "shares"], "A")
           where circle is not null
           from both in triangle is null ? [edit with { Beside = [circle] }] : (FormulaEdit[])
               [edit with { Beside = [circle] }, edit with { Beside = [circle, triangle] }, edit with { Section = circle, Beside = [triangle] }]
           select both with { Cost = edit.Cost + 0.1 },
    ]);

    /// <summary>A section with the same edit; null if there is none.</summary>
    /// <param name="point">What Q is called there.</param>
    private static FormulaSection? Alike(FormulaEdit edit, FormulaSection section, string point) => EditFactory.EditsOf(section).FirstOrDefault(
        other => other.Operator == edit.Operator && other.Formula?.Name == edit.Formula!.Name && other.Meant == edit.Meant.Replace("Q", point)
            && other.Written == edit.Written.Replace("Q", point))?.Section;

    /// <summary>Whether a style computes what the scene needs.</summary>
    private static bool IsPossible(FormulaSection section, Scene scene) => section.Kind switch
    {
        SectionKind.Sample => section == FormulaProgram.For(scene.Camera)[SectionKind.Sample],
        SectionKind.Rule => section.Style == "distance" == (scene.Camera.Clip == ClipMode.Distance),
        _ => true,
    };
}
