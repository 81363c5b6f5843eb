using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>Finds which of a candidate's mistakes show, and which other mistakes draw the same picture.</summary>
internal sealed class SuspectFinder(SceneDiagnosis prepared, Evidence evidence)
{
    /// <param name="likeliest">The picture of the first suspect.</param>
    public Suspect Of(WrongProgram candidate, WrongProgram likeliest)
    {
        Mistake[] twins = [];
        var own = candidate.For(prepared.Scene)!;
        var drawn = evidence.Draw(own);
        var shown = Visible(candidate, drawn);
        if (shown is [var named] && !own.Scatters && prepared.Budget?.IsSpent() != true)
        {
            var way = candidate.Variants.Count > 0 ? candidate.Base : Unfinished.Nothing;
            twins = [.. prepared.Known.AsParallel().AsOrdered().WithDegreeOfParallelism(prepared.Threads ?? Environment.ProcessorCount)
                .Where(other => other.Id != named.Id && other.Variants.Any(
                    variant => AreAlike(drawn, new WrongProgram(way, [variant], candidate.OtherSample))))];
        }
        var isSame = likeliest.For(prepared.Scene) is { } first && own.Scatters == first.Scatters && evidence.AreAlike(drawn, first);
        var isTypical = candidate.Misfit.Unexplained <= Judgement.Explained * evidence.WrongCount && candidate.Unusual == 0;
        return new(shown, candidate.Misfit.Unexplained, candidate.OtherSample, twins, candidate.Base.NotYet, isSame,
            isSame || candidate.Total - likeliest.Total < Priors.AsLikely, isTypical);
    }

    /// <summary>The mistakes that would also make a program lose the missing shapes.</summary>
    public IEnumerable<WrongProgram> HidingMistakes(WrongProgram best)
    {
        var without = evidence.Draw(best.For(prepared.Scene)!);
        var rest = new Unfinished([.. best.Base.NotYet.Except(best.Base.Kinds)]);
        return from mistake in prepared.Known
               where best.Base.Kinds.All(kind => (mistake.Affects & Mistake.KindOf(kind)) != 0)
               let candidate = mistake.Variants.Select(variant => best with { Base = rest, Variants = [.. best.Variants, variant] })
                   .FirstOrDefault(candidate => AreAlike(without, candidate))
               where candidate is not null
               orderby candidate.Variants[^1] != mistake, BitOperations.PopCount((uint)mistake.Affects) // the commonest, then those of few shapes
               select candidate;
    }

    private bool AreAlike(Evidence.Drawn drawn, WrongProgram other) =>
        other.For(prepared.Scene) is { } program && evidence.AreAlike(drawn, program);

    /// <summary>A program's mistakes that show. Of zNear and zFar, which are not written yet, the picture may show only one.</summary>
    private Mistake[] Visible(WrongProgram candidate, Evidence.Drawn drawn)
    {
        var hidden = candidate.Named.Except(candidate.Variants).FirstOrDefault(part => candidate.Named.Count > 1
            && FormulaProgram.For(prepared.Scene.Camera).With([.. candidate.Named.Where(other => other != part),
                .. candidate.Mistakes.Except(candidate.Variants)]) is { } rest && evidence.AreAlike(drawn, rest));
        return [.. candidate.Named.Where(mistake => mistake != hidden)];
    }
}
