namespace RayCaster.Teaching.Diagnosis;

/// <summary>A program that may have drawn the pictures: changes of the slides' formulas, and what they leave unexplained.</summary>
internal sealed record Hypothesis(FormulaProgram Program, ImmutableArray<Change> Changes)
{
    private const int MaxMistakes = 2;

    /// <summary>The right program.</summary>
    public static Hypothesis Right { get; } = new(FormulaProgram.Slides, []);

    /// <summary>What it leaves unexplained of each picture.</summary>
    public ImmutableArray<Residual> Residuals { get; init; } = [];

    /// <summary>The bits of the changes and of what they leave unexplained.</summary>
    public double Total { get; init; }

    /// <summary>How many bits it saves compared with the one that it extends.</summary>
    public double Gain { get; init; } = 1;

    /// <summary>Whether a picture proves it wrong: <see cref="PictureSample.Contradicts"/>.</summary>
    public bool IsContradicted { get; init; }

    /// <summary>What the changes cost.</summary>
    public double Bits { get; } = Changes.Sum(change => change.Bits);

    /// <summary>The same for hypotheses that draw the same.</summary>
    public string ResidualKey => string.Join(' ', Residuals);

    /// <summary>What it leaves unexplained of all pictures.</summary>
    public Residual Residual => Residuals.Aggregate((sum, residual) => sum + residual);

    /// <summary>The parts that are not written yet.</summary>
    public IReadOnlyList<string> MissingParts => [.. Changes.Select(change => change.MissingPart).OfType<string>()];

    /// <summary>Which lines no loop reached, in words; null if the program reaches all.</summary>
    public string? Unreached => Program.Unreached?.Sentence;

    /// <summary>The kinds of shape that are not drawn.</summary>
    public IReadOnlyList<string> MissingShapes => [.. MissingParts.Where(MissingPart.IsShape)];

    /// <summary>Whether rays also pass through the other sample point of each pixel.</summary>
    public bool HasOtherSample => Changes.Any(change => change.IsOtherSample) && !IsOtherSample;

    /// <summary>The mistakes; the other sample point counts only if there is nothing else.</summary>
    public IReadOnlyList<Change> Mistakes => [.. Changes.Where(change => change.IsMistake || (change.IsOtherSample && IsOtherSample))];

    /// <summary>The mistakes as they are told: "no attenuation" is one, too, if all shapes are drawn.</summary>
    public IReadOnlyList<Change> Reported => MissingShapes.Count > 0 ? Mistakes : [.. Mistakes, .. MissingPart.AsMistakes(MissingParts)];

    /// <summary>Equal for hypotheses of the same parts and mistakes, in any order and any way of writing them.</summary>
    public string Key => string.Join(' ', MissingParts.Concat(Mistakes.Select(mistake => mistake.Id)).Order(StringComparer.Ordinal));

    /// <summary>Whether each mistake is what most people write who make it.</summary>
    public bool IsUsual => Mistakes.All(mistake => mistake.Place is not null || mistake.IsUsual);

    /// <summary>Whether one of its mistakes is in the formulas of a kind of shape alone.</summary>
    public bool IsAbout(string kind) => Changes.Any(change => change.IsMistake && change.IsOnlyOf(kind));

    private bool IsOtherSample => Changes.All(change => change.IsOtherSample);

    /// <summary>A program with changes; null if they do not fit together.</summary>
    public static Hypothesis? Create(params IEnumerable<Change> changes) =>
        changes.Aggregate((Hypothesis?)Right, (all, change) => all?.Plus(change));

    /// <summary>With one more change; null if it does not fit, or if it is a third mistake: three explain any picture by chance.</summary>
    public Hypothesis? With(Change change)
    {
        if (Changes.Any(own => own == change || (own.IsMistake && own.Id != Change.NoName && own.Id == change.Id))) return null;
        return change.IsMistake && Changes.Count(own => own.IsMistake) == MaxMistakes ? null : Plus(change);
    }

    /// <summary>With one more change, whatever it is; null if it does not fit.</summary>
    public Hypothesis? Plus(Change change) => change.In(Program) is { } program ? new(program, Changes.Add(change)) : null;
}
