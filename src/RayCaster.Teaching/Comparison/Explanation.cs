namespace RayCaster.Teaching.Comparison;

/// <summary>In which way a picture differs from the right one, but for the fourth, its formulas.</summary>
internal enum Way
{
    /// <summary>Each byte follows from the right one.</summary>
    Values,

    /// <summary>The right pixels are elsewhere, or missing.</summary>
    Places,

    /// <summary>A model is missing, or has another colour.</summary>
    Models,
}

/// <summary>What explains a wrong picture without a change of a formula.</summary>
/// <param name="Bits">Its price, on the scale of <see cref="Priors"/>.</param>
/// <param name="Unexplained">How many pixels it leaves wrong.</param>
internal sealed record Explanation(Way Way, string Sentence, double Bits, double Unexplained = 0)
{
    /// <summary>The price, and that of what is left of so many wrong pixels.</summary>
    public double Total(double wrong) => Bits + Priors.BitsOf(Unexplained, wrong);
}
