namespace RayCaster.Teaching;

/// <summary>All changes that people may have made in a program that draws a scene.</summary>
internal static class ChangeSource
{
    /// <summary>What a program may not do yet.</summary>
    public static IEnumerable<Change> Missing(IEnumerable<string> parts) => parts.Select(Missing);

    /// <summary>A part that is not written yet: a kind of shape, or what some mistakes of the catalogue draw together.</summary>
    public static Change Missing(string part)
    {
        Change[] same = [.. MistakeCatalog.DrawnWithout(part).Select(mistake => mistake.Usual)];
        ImmutableArray<ImmutableArray<StepChange>> ways = same.Length == 0 ? [[new StepChange.LeftOut(part)]]
            : [.. same.Aggregate((IEnumerable<ImmutableArray<StepChange>>)[[]], (all, change) =>
                from before in all from way in change.Ways select before.AddRange(way))];
        return new(ways, Priors.NotYet) { Missing = part };
    }

    /// <summary>Known mistakes, each in all its ways.</summary>
    /// <param name="likely">Which are likelier than the others; null for none.</param>
    public static IEnumerable<Change> Of(IEnumerable<Mistake> known, Predicate<Change>? likely) =>
        from mistake in known
        from change in mistake.Changes
        select likely is null || change.IsOtherSample || likely(change) ? change : change with { Bits = change.Bits + Priors.Unlikely };

    /// <summary>Further wordings of known mistakes.</summary>
    public static IEnumerable<Change> Wordings(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from section in SectionsOf(scene)
        from edit in EditFactory.NamedEditsOf(section)
        where known.Any(mistake => mistake.Id == edit.Label)
        select Of(edit);

    /// <summary>The slips in each step that a scene shows, in each style. Those of a mistake that is not among the known ones are left out.
    /// </summary>
    public static IEnumerable<Change> Slips(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from edit in SlipsIn(scene)
        where edit.Label is null || known.Any(mistake => mistake.Id == edit.Label)
        select Of(edit);

    private static Change Of(FormulaEdit edit) => new([[.. edit.Beside.Append(edit.Section).Select(section => new StepChange.Slipped(section))]],
        edit.Label is null ? Priors.Unknown + Priors.PerCost * (edit.Cost - 0.8) : Priors.Known + Priors.Wording * edit.Cost)
    {
        Slip = edit,
    };

    /// <summary>Other right styles, which show beside a mistake.</summary>
    public static IEnumerable<Change> Styles(Scene scene)
    {
        var slides = FormulaProgram.For(scene.Camera);
        return from section in SectionsOf(scene)
               where section.Kind.IsOfShape() || section.Kind is SectionKind.Rule or SectionKind.Light or SectionKind.Pixel
               orderby Order(section.Kind)
               where section != slides[section.Kind]
               select new Change([[new StepChange.OtherStyle(slides[section.Kind], section)]], Priors.Style);

        static int Order(SectionKind kind) => kind == SectionKind.Pixel ? int.MaxValue : (int)kind;
    }

    /// <summary>The sections that a scene shows, in each style.</summary>
    private static IEnumerable<FormulaSection> SectionsOf(Scene scene)
    {
        var shown = scene.Models.Select(model => FormulaEvaluator.KindOf(model)).ToHashSet();
        return from kind in Enum.GetValues<SectionKind>()
               where !kind.IsOfShape() || shown.Contains(kind)
               from section in FormulaBook.Slides.StylesOf(kind)
               where IsPossible(section, scene)
               select section;
    }

    private static IEnumerable<FormulaEdit> SlipsIn(Scene scene)
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
