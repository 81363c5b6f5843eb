namespace RayCaster.Teaching.Diagnosis;

/// <summary>Finds which of a hypothesis's mistakes show, and which other mistakes draw the same picture.</summary>
internal sealed class SuspectFinder(Diagnoser prepared, PictureSample sample)
{
    /// <summary>How many other formulas are named.</summary>
    private const int MaxFormulas = 3;

    /// <param name="likeliest">The first suspect.</param>
    public Suspect Examine(Hypothesis hypothesis, Hypothesis likeliest)
    {
        Mistake[] twins = [];
        string[] others = [];
        var own = hypothesis.Program;
        var shown = Visible(hypothesis);
        if (shown is [var named] && !own.HasNoisyTriangles && prepared.Budget?.IsSpent() != true)
        {
            var rest = Hypothesis.Create(hypothesis.Changes.Where(change => hypothesis.HasOtherSample && change.IsOtherSample
                || (change.MissingPart is not null && hypothesis.Mistakes.Count > 0)))!;
            twins = Those(prepared.Known, other => other.Id != named.Id && other.Changes.Any(change => AreTwins(own, rest.Plus(change))));
            if (ReferenceEquals(hypothesis, likeliest)) others = OtherFormulas(named, own, rest);
        }
        var isSame = own.HasNoisyTriangles == likeliest.Program.HasNoisyTriangles && sample.AreAlike(own, likeliest.Program);
        var isTypical = hypothesis.Residual.Unexplained <= Decision.Explained * sample.WrongCount && hypothesis.IsUsual;
        shown = [.. shown.Select(mistake => Fits(mistake, hypothesis) ? mistake : MutationNaming.Unnamed(mistake))];
        return new(shown, hypothesis.Residual.Unexplained, hypothesis.HasOtherSample, twins, hypothesis.MissingParts, isSame,
            isSame || hypothesis.Total - likeliest.Total < Priors.AsLikely, isTypical)
        {
            OtherFormulas = others,
        };
    }

    /// <summary>The formulas of the step that a mistake changes in which a slip draws the same, but for its own, in words: the scene cannot tell
    /// them apart.</summary>
    private string[] OtherFormulas(Change named, FormulaProgram own, Hypothesis rest)
    {
        if (named.OwnSteps.Distinct().ToArray() is not [var step] || !step.IsOfShape() && !step.IsOfRays()) return [];
        var right = FormulaBook.Slides[step, own[step].Style];
        var changed = right.Formulas.Where(formula => !own[step].Formulas.Contains(formula)).Select(formula => formula.Computed);
        Mutation[] slips = [.. MutationFactory.MutationsOf(right).Where(mutation => mutation.Formula is not null && mutation.Label != named.Id)];
        return
        [
            .. Those(slips, mutation => AreAlike(own, rest.Plus(ChangeSource.From(mutation))))
                .Select(mutation => mutation.Formula!.Computed).Distinct().Except(changed).Select(FormulaBook.Slides.InWords).Take(MaxFormulas),
        ];
    }

    /// <summary>The mistakes that would also make a program lose the missing shapes.</summary>
    public IEnumerable<Hypothesis> HidingMistakes(Hypothesis best)
    {
        var shapes = best.MissingShapes;
        var rest = Hypothesis.Create(best.Changes.Where(change => change.MissingPart is null || !shapes.Contains(change.MissingPart)))!;
        return from mistake in prepared.Known
               where shapes.All(mistake.Touches)
               let hiding = mistake.Changes.Select(rest.Plus).FirstOrDefault(other => AreAlike(best.Program, other))
               where hiding is not null
               orderby !hiding.Changes[^1].IsUsual, mistake.Steps.Count // the commonest, then those of few shapes
               select hiding with { Residuals = best.Residuals, Total = best.Total };
    }

    /// <summary>Whether the question of a mistake fits a slip that has its name. A question about a size fits only if the picture is also that of
    /// what people write who make the mistake: "half of the height" is no question about one that is twice too large.</summary>
    private bool Fits(Change slip, Hypothesis hypothesis) => slip is not { Mutation: { } mutation, Mistake: { } mistake }
        || IsAbout(mistake, mutation) && (!IsOfSize(mutation)
            || mistake.Changes.Any(change => AreAlike(hypothesis, hypothesis.Changes.Select(own => own == slip ? change : own))));

    /// <summary>Whether a mistake is made in the formula that is edited. Only the slides' own style has its names.</summary>
    private static bool IsAbout(Mistake mistake, Mutation mutation)
    {
        if (mutation.Formula is not { } formula || mutation.Right != FormulaBook.Slides.StylesOf(mutation.Step.Kind)[0]) return true;
        string[] names = [.. mistake.Changes.SelectMany(change => change.OfSteps).OfType<StepChange.Written>()
            .Where(step => step.Kind == mutation.Step.Kind && step.Style is null).SelectMany(step => step.Formulas).Select(written => written.Name)];
        return names.Length == 0 || mutation.Step.Kind.IsOfHits()
            || MistakeBook.Labels.Any(label => label.Id == mistake.Id && label.Subjects.Contains(formula.Computed))
            || names.Contains(formula.Name == Formula.Near || formula.Name == Formula.Far ? "hits" : formula.Name.Text);
    }

    private static bool IsOfSize(Mutation mutation) => mutation.Operator.IsOfSize
        || mutation is { Step.Kind: StepKind.Camera, Formula.Right.Dimension.Kind: ValueKind.Number };

    private bool AreAlike(FormulaProgram one, Hypothesis? other) => other is not null && sample.AreAlike(one, other.Program);

    private bool AreAlike(Hypothesis one, IEnumerable<Change> others) => AreAlike(one.Program, Hypothesis.Create(others));

    /// <summary>Whether a mistake draws the same picture, as "check" sees it.</summary>
    private bool AreTwins(FormulaProgram one, Hypothesis? other) =>
        AreAlike(one, other) && prepared.Rendering.AreAlike(one, other!.Program);

    /// <summary>Those for which something holds that takes long to find out.</summary>
    private T[] Those<T>(IReadOnlyList<T> all, Predicate<T> holds)
    {
        var found = new bool[all.Count];
        SearchBudget.Do(null, all.Count, all.Count, prepared.Threads, i => found[i] = holds(all[i]));
        return [.. all.Where((_, i) => found[i])];
    }

    /// <summary>The mistakes that show. Of zNear and zFar, which are not written yet, the picture may show only one.</summary>
    private Change[] Visible(Hypothesis hypothesis)
    {
        var reported = hypothesis.Reported;
        var missing = reported.Except(hypothesis.Mistakes).ToArray();
        var rest = hypothesis.Changes.Where(change => change.MissingPart is null);
        var hidden = reported.Count < 2 ? null
            : missing.FirstOrDefault(part => AreAlike(hypothesis, rest.Concat(missing.Where(other => other != part))));
        return [.. reported.Where(mistake => mistake != hidden)];
    }
}
