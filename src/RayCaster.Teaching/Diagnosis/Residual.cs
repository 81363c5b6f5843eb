namespace RayCaster.Teaching.Diagnosis;

/// <summary>How far a mistake is from explaining a picture, in pixels.</summary>
/// <param name="Unexplained">How many pixels differ by more than rounding.</param>
/// <param name="Error">The sum of the pixels' greatest differences, each 1 for black against white. It decides between equals.</param>
internal readonly record struct Residual(double Unexplained, double Error) : IComparable<Residual>
{
    /// <summary>One number to sort by: mainly the unexplained pixels, a little the error.</summary>
    public double Weight => Unexplained + PerError * Error;

    private const double PerError = 0.02;

    /// <summary>The weight of pixels that are wrong, and of others that are off by a level.</summary>
    public static double WeightOf(double wrong, int offByOne) => wrong + PerError * offByOne / 255;

    public static Residual operator +(Residual a, Residual b) => new(a.Unexplained + b.Unexplained, a.Error + b.Error);

    public static Residual operator *(Residual a, double factor) => new(a.Unexplained * factor, a.Error * factor);

    public int CompareTo(Residual other) => Weight.CompareTo(other.Weight);
}
