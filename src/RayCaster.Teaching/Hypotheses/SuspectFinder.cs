namespace RayCaster.Teaching.Hypotheses;

/// <summary>Finds which of a hypothesis's mistakes show, and which other mistakes draw the same picture.</summary>
internal sealed class SuspectFinder(SceneDiagnosis prepared, PictureSample sample)
{
    /// <param name="likeliest">The first suspect.</param>
    public Suspect Of(Hypothesis hypothesis, Hypothesis likeliest)
    {
        Mistake[] twins = [];
        var own = hypothesis.Programs[0];
        var drawn = sample.Draw(own);
        var shown = Visible(hypothesis, drawn);
        if (shown is [var named] && !own.Scatters && prepared.Budget?.IsSpent() != true)
        {
            var rest = With(hypothesis.Changes.Where(change => hypothesis.HasOtherSample && change.IsOtherSample
                || (change.Missing is not null && hypothesis.Mistakes.Count > 0)))!;
            twins = [.. prepared.Known.AsParallel().AsOrdered().WithDegreeOfParallelism(prepared.Threads ?? Environment.ProcessorCount)
                .Where(other => other.Id != named.Id && other.Changes.Any(change => AreAlike(drawn, rest.Plus(change))))];
        }
        var isSame = own.Scatters == likeliest.Programs[0].Scatters && sample.AreAlike(drawn, likeliest.Programs[0]);
        var isTypical = hypothesis.Residual.Unexplained <= Decision.Explained * sample.WrongCount && hypothesis.IsUsual;
        shown = [.. shown.Select(mistake => Fits(mistake, hypothesis, drawn) ? mistake : MutantNaming.Unnamed(mistake))];
        return new(shown, hypothesis.Residual.Unexplained, hypothesis.HasOtherSample, twins, hypothesis.Missing, isSame,
            isSame || hypothesis.Total - likeliest.Total < Priors.AsLikely, isTypical);
    }

    /// <summary>The mistakes that would also make a program lose the missing shapes.</summary>
    public IEnumerable<Hypothesis> HidingMistakes(Hypothesis best)
    {
        var shapes = best.MissingShapes;
        var without = sample.Draw(best.Programs[0]);
        var rest = With(best.Changes.Where(change => change.Missing is null || !shapes.Contains(change.Missing)))!;
        return from mistake in prepared.Known
               where shapes.All(mistake.Touches)
               let hiding = mistake.Changes.Select(rest.Plus).FirstOrDefault(other => AreAlike(without, other))
               where hiding is not null
               orderby !hiding.Changes[^1].IsUsual, mistake.Steps.Count // the commonest, then those of few shapes
               select hiding with { Residuals = best.Residuals, Total = best.Total };
    }

    /// <summary>Whether the question of a mistake fits a slip that has its name. A question about a size fits only if the picture is also that of
    /// what people write who make the mistake: "half of the height" is no question about one that is twice too large.</summary>
    private bool Fits(Change slip, Hypothesis hypothesis, PictureSample.Drawn drawn) => slip is not { Mutant: { } mutant, Mistake: { } mistake }
        || !IsOfSize(mutant)
        || mistake.Changes.Any(change => AreAlike(drawn, With(hypothesis.Changes.Select(own => own == slip ? change : own))));

    private static bool IsOfSize(Mutant mutant) => mutant.Operator.IsOfSize
        || mutant is { Section.Kind: StepKind.Camera, Formula.Right.Dimension.Kind: ValueKind.Number };

    private bool AreAlike(PictureSample.Drawn drawn, Hypothesis? other) => other is not null && sample.AreAlike(drawn, other.Programs[0]);

    private Hypothesis? With(IEnumerable<Change> changes) => Hypothesis.Create([prepared.Scene], changes);

    /// <summary>The mistakes that show. Of zNear and zFar, which are not written yet, the picture may show only one.</summary>
    private Change[] Visible(Hypothesis hypothesis, PictureSample.Drawn drawn)
    {
        var told = hypothesis.Told;
        var hidden = told.Count < 2 ? null : told.Except(hypothesis.Mistakes).FirstOrDefault(part => AreAlike(drawn, With(
            hypothesis.Changes.Where(change => change.Missing is null).Concat(told.Except(hypothesis.Mistakes).Where(other => other != part)))));
        return [.. told.Where(mistake => mistake != hidden)];
    }
}
