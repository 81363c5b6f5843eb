using System.Numerics;

namespace RayCaster.Teaching;

/// <summary>Finds out of a trial what a reader should know: which of its mistakes show, and which other mistakes draw the same picture.</summary>
internal sealed class SuspectFinder(SceneDiagnosis prepared, Evidence evidence)
{
    /// <param name="likeliest">The picture of the first suspect.</param>
    public Suspect Of(WrongProgram trial, Lab likeliest)
    {
        Mistake[] twins = [];
        var own = trial.Draw(prepared.Scene);
        var drawn = evidence.Draw(own);
        var shown = Visible(trial, drawn);
        if (shown is [var named] && !own.Scatters && prepared.Budget?.IsSpent() != true)
        {
            var way = trial.Wordings.Count > 0 ? trial.Base : Unfinished.Nothing;
            twins = [.. prepared.Known.AsParallel().AsOrdered().WithDegreeOfParallelism(prepared.Threads ?? Environment.ProcessorCount)
                .Where(other => other.Id != named.Id && other.Wordings.Any(
                    wording => evidence.AreAlike(drawn, new WrongProgram(way, [wording], trial.OtherSample).Draw(prepared.Scene))))];
        }
        var isSame = own.Scatters == likeliest.Scatters && evidence.AreAlike(drawn, likeliest);
        var isTypical = trial.Misfit.Unexplained <= Judgement.Explained * evidence.WrongCount && trial.Unusual == 0;
        return new(shown, trial.Misfit.Unexplained, trial.OtherSample, twins, trial.Base.NotYet, isSame, isTypical);
    }

    /// <summary>The mistakes that would also make a program lose the missing shapes.</summary>
    public IEnumerable<WrongProgram> Losing(WrongProgram best)
    {
        var without = evidence.Draw(best.Draw(prepared.Scene));
        var rest = new Unfinished([.. best.Base.NotYet.Except(best.Base.Kinds)]);
        return from mistake in prepared.Known
               where best.Base.Kinds.All(kind => (mistake.Concerns & Mistake.KindOf(kind)) != 0)
               let trial = mistake.Wordings.Select(wording => best with { Base = rest, Wordings = [.. best.Wordings, wording] })
                   .FirstOrDefault(trial => evidence.AreAlike(without, trial.Draw(prepared.Scene)))
               where trial is not null
               orderby trial.Wordings[^1] != mistake, BitOperations.PopCount((uint)mistake.Concerns) // the commonest, then those of few shapes
               select trial;
    }

    /// <summary>A program's mistakes, but for one of zNear and zFar that are not written yet, if the picture does not show it.</summary>
    private Mistake[] Visible(WrongProgram trial, Evidence.Drawn drawn)
    {
        var hidden = trial.Named.Except(trial.Wordings).FirstOrDefault(part => trial.Named.Count > 1 && evidence.AreAlike(drawn,
            new(prepared.Scene, [.. trial.Named.Where(other => other != part), .. trial.Mistakes.Except(trial.Wordings)])));
        return [.. trial.Named.Where(mistake => mistake != hidden)];
    }
}
