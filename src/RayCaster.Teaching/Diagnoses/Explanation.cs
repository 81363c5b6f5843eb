namespace RayCaster.Teaching;

/// <summary>A program that may have drawn the pictures: changes of the slides' formulas.</summary>
/// <param name="Programs">The program for the scene of each picture.</param>
internal sealed record Explanation(ImmutableArray<FormulaProgram> Programs, ImmutableArray<ProgramChange> Changes)
{
    private const int MaxMistakes = 2;

    /// <summary>What the changes cost.</summary>
    public double Bits { get; } = Changes.Sum(change => change.Bits);

    /// <summary>What it leaves unexplained of each picture.</summary>
    public ImmutableArray<Misfit> Misfits { get; init; } = [];

    /// <summary>The same for explanations that draw the same.</summary>
    public string Left => string.Join(' ', Misfits);

    /// <summary>The bits of the changes and of what they leave unexplained.</summary>
    public double Total { get; init; }

    /// <summary>How many bits it saves compared with the one that it extends.</summary>
    public double Gain { get; init; } = 1;

    /// <summary>With one more change; null if it does not fit, or if it is a third mistake: three explain any picture by chance.</summary>
    public Explanation? With(ProgramChange change)
    {
        if (Changes.Any(own => own == change || (own.IsMistake && own.Id != EditNaming.Id && own.Id == change.Id))) return null;
        if (change.IsMistake && Changes.Count(own => own.IsMistake) == MaxMistakes) return null;
        var programs = Programs.Select(change.In).ToImmutableArray();
        return programs.Any(program => program is null) ? null : new([.. programs!], Changes.Add(change));
    }
}
