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
        return new(same.Length == 0 ? [new StepChange.MissingShape(part)] : [.. same.SelectMany(change => change.OfSteps)], Priors.MissingPart)
        {
            MissingPart = part,
        };
    }

    /// <summary>Lines that no loop reaches.</summary>
    public static Change From(UnreachedLines lines) => new([new StepChange.Unreached(lines)], Priors.BitsOf(lines));

    /// <summary>Known mistakes, each in all its ways.</summary>
    /// <param name="likely">Which are likelier than the others; null for none.</param>
    public static IEnumerable<Change> From(IEnumerable<Mistake> known, Predicate<Change>? likely) =>
        from mistake in known
        from change in mistake.Changes
        select likely is null || change.IsOtherSample || likely(change) ? change : change with { Bits = change.Bits + Priors.Unlikely };

    /// <summary>Further wordings of known mistakes.</summary>
    public static IEnumerable<Change> Wordings(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from step in StepsOf(scene)
        from mutation in MutationFactory.NamedMutationsOf(step)
        where known.Any(mistake => mistake.Id == mutation.Label)
        select From(mutation);

    /// <summary>The slips in each step that a scene shows, in each style. Those of a mistake that is not among the known ones are left out.
    /// </summary>
    public static IEnumerable<Change> Mutations(Scene scene, IReadOnlyCollection<Mistake> known) =>
        from mutation in MutationsIn(scene)
        where mutation.Label is null || known.Any(mistake => mistake.Id == mutation.Label)
        select From(mutation);

    /// <summary>A slip.</summary>
    public static Change From(Mutation mutation) => new([.. mutation.Beside.Append(mutation.Step).Select(step => new StepChange.Mutated(step))],
        mutation.Label is null ? Priors.Unknown + Priors.PerCost * (mutation.Cost - 0.8) : Priors.Known + Priors.Wording * mutation.Cost)
    {
        Mutation = mutation,
    };

    /// <summary>Other right styles, which show beside a mistake.</summary>
    public static IEnumerable<Change> Styles(Scene scene) =>
        from step in StepsOf(scene)
        where step.Kind is not (StepKind.Vectors or StepKind.Camera) && step != FormulaBook.Slides.StylesOf(step.Kind)[0]
        orderby step.Kind == StepKind.Pixel ? int.MaxValue : (int)step.Kind
        select new Change([new StepChange.OtherStyle(step)], Priors.Style);

    /// <summary>The steps that a scene shows, in each style.</summary>
    private static IEnumerable<Step> StepsOf(Scene scene)
    {
        var shown = scene.Models.Select(model => FormulaEvaluator.KindOf(model)).ToHashSet();
        return from kind in Enum.GetValues<StepKind>()
               where kind.IsOfShape() ? shown.Contains(kind)
                   : kind.IsOfSample() ? kind == StepKinds.SampleOf(scene.Camera)
                   : kind is not (StepKind.Depth or StepKind.Distance) || kind == StepKinds.RuleOf(scene.Camera)
               from step in FormulaBook.Slides.StylesOf(kind)
               select step;
    }

    private static IEnumerable<Mutation> MutationsIn(Scene scene)
    {
        foreach (var step in StepsOf(scene))
        {
            var mutations = MutationFactory.MutationsOf(step);
            foreach (var mutation in step.Kind == StepKind.Plane ? [.. mutations, .. shared.Value] : mutations)
            {
                yield return mutation;
                if (step.Kind == StepKind.Vectors)
                    yield return mutation with { Beside = [FormulaBook.Slides[StepKind.Light, "doubled"]], Cost = mutation.Cost + 0.1 };
                if (step.Kind == StepKind.Camera && mutation.Formula?.Name.Text == "W" && scene.Camera.Clip == ClipMode.Depth)
                    yield return mutation with { Beside = [FormulaBook.Slides[StepKind.Depth, "aim"]], Cost = mutation.Cost + 0.1 };
            }
        }
    }

    /// <summary>Slips in the plane's t that circles and triangles share, because it is one method for all of them.</summary>
    private static readonly Lazy<Mutation[]> shared = new(() =>
    [
        .. from mutation in MutationFactory.MutationsOf(FormulaBook.Slides.StylesOf(StepKind.Plane)[0])
           where mutation.Place is not null
           let circle = Alike(mutation, FormulaBook.Slides.StylesOf(StepKind.Circle)[0], "C")
           let triangle = Alike(mutation, FormulaBook.Slides[StepKind.Triangle, "shares"], "A")
           where circle is not null
           from both in triangle is null ? [mutation with { Beside = [circle] }] : (Mutation[])
           [
               mutation with { Beside = [circle] }, mutation with { Beside = [circle, triangle] },
               mutation with { Step = circle, Beside = [triangle] },
           ]
           select both with { Cost = mutation.Cost + 0.1 },
    ]);

    /// <summary>A step with the same edit; null if there is none.</summary>
    /// <param name="point">What Q is called there.</param>
    private static Step? Alike(Mutation mutation, Step step, string point) => MutationFactory.MutationsOf(step).FirstOrDefault(
        other => other.Operator == mutation.Operator && other.Formula?.Name == mutation.Formula!.Name
            && other.Meant == mutation.Meant.Replace("Q", point)
            && other.Written == mutation.Written.Replace("Q", point))?.Step;
}
