namespace RayCaster.Teaching.Diagnosis;

/// <summary>
/// Decides what explains a program's pictures, one or several: the formulas that a search finds, if they are shorter in bits than what the wrong
/// pictures show by themselves. Both reports, of one picture and of a program, only tell it.
/// </summary>
internal sealed class Decision
{
    /// <summary>What explains a picture leaves at most this share of the wrong pixels.</summary>
    public const double Explained = 0.1;

    private readonly IReadOnlyList<PictureSample> samples;
    private readonly IReadOnlyList<Observations> observed;
    private readonly SearchOptions options;
    private readonly Lazy<double> without;

    /// <param name="samples">A sample of each picture.</param>
    /// <param name="wrong">The places of the pictures that are wrong.</param>
    /// <param name="observed">What these show by themselves, in their order.</param>
    public Decision(IReadOnlyList<PictureSample> samples, IReadOnlyList<int> wrong, IReadOnlyList<Observations> observed, SearchOptions options)
    {
        (this.samples, this.options, this.observed, Wrong) = (samples, options, observed, wrong);
        without = new(() => Enumerable.Range(0, Wrong.Count).Sum(Alone));
    }

    /// <summary>The places of the wrong pictures among all.</summary>
    public IReadOnlyList<int> Wrong { get; }

    /// <summary>Whether no picture shows more than very many programs draw.</summary>
    public bool TellsNothing => Wrong.Count == samples.Count && observed.All(of => of.Plain is not null);

    /// <summary>Programs that may have drawn the pictures, the shortest explanation first.</summary>
    public List<Hypothesis> Ranked => field ??= new HypothesisSearch(samples, options,
        samples is [{ Difference: { } difference }] ? UnreachedLinesFinder.Find(difference) : null, without).Run();

    /// <summary>The shortest.</summary>
    public Hypothesis Best => Ranked[0];

    /// <summary>The bits of what the wrong pictures show by themselves, where that explains them; otherwise of some other program.</summary>
    public double Without => without.Value;

    /// <summary>Whether the shortest program is named.</summary>
    public bool IsNamed => Best.Total < Priors.LeastWithoutFormulas || Best.Total < Without;

    /// <summary>The places of the wrong pictures that the shortest program does not explain better than they explain themselves.</summary>
    public IReadOnlyList<int> Unexplained => field ??=
        [.. Wrong.Where((place, i) => samples[place].BitsOf(Best.Residuals[place]) >= Alone(i))];

    /// <summary>Whether a program is short enough to be mentioned where none is named.</summary>
    public bool IsMentioned(Hypothesis program) => program.Total < Priors.Mentioned * Wrong.Count;

    private double Alone(int i) => observed[i].Best?.Total(samples[Wrong[i]].WrongCount) ?? Priors.OtherProgram;
}
