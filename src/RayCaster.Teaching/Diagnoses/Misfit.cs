namespace RayCaster.Teaching;

/// <summary>How far a mistake is from explaining a picture, in pixels.</summary>
/// <param name="Unexplained">How many pixels differ by more than rounding.</param>
/// <param name="Error">The sum of the pixels' greatest differences, each 1 for black against white. It decides between equals.</param>
internal readonly record struct Misfit(double Unexplained, double Error) : IComparable<Misfit>
{
    /// <summary>One number to sort by: mainly the unexplained pixels, a little the error.</summary>
    public double Weight => Unexplained + 0.02 * Error;

    public static Misfit operator +(Misfit a, Misfit b) => new(a.Unexplained + b.Unexplained, a.Error + b.Error);

    public static Misfit operator *(Misfit a, double factor) => new(a.Unexplained * factor, a.Error * factor);

    public int CompareTo(Misfit other) => Weight.CompareTo(other.Weight);
}
