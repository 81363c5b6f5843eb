namespace RayCaster.Teaching.Diagnosis;

/// <summary>How far a mistake is from explaining a picture, in pixels.</summary>
/// <param name="Unexplained">How many pixels differ by more than rounding.</param>
/// <param name="Error">The sum of the pixels' greatest differences, each 1 for black against white. It decides between equals.</param>
internal readonly record struct Residual(double Unexplained, double Error) : IComparable<Residual>
{
    /// <summary>One number to sort by: mainly the unexplained pixels, a little the error.</summary>
    public double Weight => Unexplained + Priors.PerError * Error;

    public static Residual operator +(Residual a, Residual b) => new(a.Unexplained + b.Unexplained, a.Error + b.Error);

    public static Residual operator *(Residual a, double factor) => new(a.Unexplained * factor, a.Error * factor);

    public int CompareTo(Residual other) => Weight.CompareTo(other.Weight);
}
