namespace RayCaster.Teaching.Changes;

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

    /// <summary>Lines that no loop reaches.</summary>
    public static Change Of(UnreachedLines lines) => new([[new StepChange.Unreached(lines)]], lines.Bits) { Unreached = lines };

    /// <summary>Known mistakes, each in all its ways.</summary>
    /// <param name="likely">Which are likelier than the others; null for none.</param>
    public static IEnumerable<Change> Of(IEnumerable<Mistake> known, Predicate<Change>? likely) =>
        from mistake in known
        from change in mistake.Changes
        select likely is null || change.IsOtherSample || likely(change) ? change : change with { Bits = change.Bits + Priors.Unlikely };

    /// <summary>Further wordings of known mistakes.</summary>
    public static IEnumerable<Change> Wordings(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from section in SectionsOf(scene)
        from mutant in MutantFactory.NamedMutantsOf(section)
        where known.Any(mistake => mistake.Id == mutant.Label)
        select Of(mutant);

    /// <summary>The slips in each step that a scene shows, in each style. Those of a mistake that is not among the known ones are left out.
    /// </summary>
    public static IEnumerable<Change> Mutants(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from mutant in MutantsIn(scene)
        where mutant.Label is null || known.Any(mistake => mistake.Id == mutant.Label)
        select Of(mutant);

    /// <summary>A slip.</summary>
    public static Change Of(Mutant mutant) => new([[.. mutant.Beside.Append(mutant.Section).Select(section => new StepChange.Mutated(section))]],
        mutant.Label is null ? Priors.Unknown + Priors.PerCost * (mutant.Cost - 0.8) : Priors.Known + Priors.Wording * mutant.Cost)
    {
        Mutant = mutant,
    };

    /// <summary>Other right styles, which show beside a mistake.</summary>
    public static IEnumerable<Change> Styles(Scene scene)
    {
        var slides = FormulaProgram.For(scene.Camera);
        return from section in SectionsOf(scene)
               where section.Kind.IsOfShape() || section.Kind is StepKind.Rule or StepKind.Light or StepKind.Pixel
               orderby Order(section.Kind)
               where section != slides[section.Kind]
               select new Change([[new StepChange.OtherStyle(slides[section.Kind], section)]], Priors.Style);

        static int Order(StepKind kind) => kind == StepKind.Pixel ? int.MaxValue : (int)kind;
    }

    /// <summary>The sections that a scene shows, in each style.</summary>
    private static IEnumerable<Step> SectionsOf(Scene scene)
    {
        var shown = scene.Models.Select(model => FormulaEvaluator.KindOf(model)).ToHashSet();
        return from kind in Enum.GetValues<StepKind>()
               where !kind.IsOfShape() || shown.Contains(kind)
               from section in FormulaBook.Slides.StylesOf(kind)
               where IsPossible(section, scene)
               select section;
    }

    private static IEnumerable<Mutant> MutantsIn(Scene scene)
    {
        foreach (var section in SectionsOf(scene))
        {
            var mutants = MutantFactory.MutantsOf(section);
            foreach (var mutant in section.Kind == StepKind.Plane ? [.. mutants, .. shared.Value] : mutants)
            {
                yield return mutant;
                if (section.Kind == StepKind.Vectors)
                    yield return mutant with { Beside = [FormulaBook.Slides[StepKind.Light, "doubled"]], Cost = mutant.Cost + 0.1 };
                if (section.Kind == StepKind.Camera && mutant.Formula?.Name.Text == "W" && scene.Camera.Clip == ClipMode.Depth)
                    yield return mutant with { Beside = [FormulaBook.Slides[StepKind.Rule, "aim"]], Cost = mutant.Cost + 0.1 };
            }
        }
    }

    /// <summary>Slips in the plane's t that circles and triangles share, because it is one method for all of them.</summary>
    private static readonly Lazy<Mutant[]> shared = new(() =>
    [
        .. from mutant in MutantFactory.MutantsOf(FormulaBook.Slides.StylesOf(StepKind.Plane)[0])
           where mutant.Place is not null
           let circle = Alike(mutant, FormulaBook.Slides.StylesOf(StepKind.Circle)[0], "C")
           let triangle = Alike(mutant, FormulaBook.Slides[StepKind.Triangle, "shares"], "A")
           where circle is not null
           from both in triangle is null ? [mutant with { Beside = [circle] }] : (Mutant[])
           [
               mutant with { Beside = [circle] }, mutant with { Beside = [circle, triangle] },
               mutant with { Section = circle, Beside = [triangle] },
           ]
           select both with { Cost = mutant.Cost + 0.1 },
    ]);

    /// <summary>A section with the same edit; null if there is none.</summary>
    /// <param name="point">What Q is called there.</param>
    private static Step? Alike(Mutant mutant, Step section, string point) => MutantFactory.MutantsOf(section).FirstOrDefault(
        other => other.Operator == mutant.Operator && other.Formula?.Name == mutant.Formula!.Name && other.Meant == mutant.Meant.Replace("Q", point)
            && other.Written == mutant.Written.Replace("Q", point))?.Section;

    /// <summary>Whether a style computes what the scene needs.</summary>
    private static bool IsPossible(Step section, Scene scene) => section.Kind switch
    {
        StepKind.Sample => section == FormulaProgram.For(scene.Camera)[StepKind.Sample],
        StepKind.Rule => section.Style == "distance" == (scene.Camera.Clip == ClipMode.Distance),
        _ => true,
    };
}
