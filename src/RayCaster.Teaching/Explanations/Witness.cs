namespace RayCaster.Teaching;

/// <summary>A double that records why it became NaN or infinite. A formula over this type, also a student's own, tells why a ray does not cross
/// the shape.</summary>
/// <param name="Value">The number; as a mask 1 for true and 0 for false.</param>
/// <param name="Loss">
/// Why <paramref name="Value"/> is NaN or infinite; for a mask that is false because an operand is NaN, why that is. <see cref="Outcome.Shows"/>
/// for other values.
/// </param>
internal readonly record struct Witness(double Value, Outcome Loss) : IReal<Witness>
{
    private const Outcome None = Outcome.Shows;

    private bool Holds => Value != 0;

    public static implicit operator Witness(double value) => new(value, None);

    public static Witness operator +(Witness a, Witness b) => Result(a.Value + b.Value, a, b);

    public static Witness operator -(Witness a, Witness b) => Result(a.Value - b.Value, a, b);

    public static Witness operator -(Witness a) => a with { Value = -a.Value };

    public static Witness operator *(Witness a, Witness b) => Result(a.Value * b.Value, a, b);

    public static Witness operator /(Witness a, Witness b) => Result(a.Value / b.Value, a, b, b.Value == 0 ? Outcome.Parallel : Outcome.NoNumber);

    public static Witness operator <(Witness a, Witness b) => Mask(a.Value < b.Value, a, b);

    public static Witness operator >(Witness a, Witness b) => Mask(a.Value > b.Value, a, b);

    public static Witness operator <=(Witness a, Witness b) => Mask(a.Value <= b.Value, a, b);

    public static Witness operator >=(Witness a, Witness b) => Mask(a.Value >= b.Value, a, b);

    public static Witness operator &(Witness a, Witness b) =>
        a.Holds && b.Holds ? new(1, None) : new(0, !a.Holds && a.Loss == None || !b.Holds && b.Loss == None ? None : Earlier(a, b));

    public static Witness operator |(Witness a, Witness b) =>
        a.Holds || b.Holds ? new(1, None) : new(0, a.Loss == None || b.Loss == None ? None : a.Loss);

    public static Witness Sqrt(Witness x) => Result(Math.Sqrt(x.Value), x, x, Outcome.PassesBy);

    public static Witness Min(Witness a, Witness b) => Result(Math.Min(a.Value, b.Value), a, b);

    public static Witness Max(Witness a, Witness b) => Result(Math.Max(a.Value, b.Value), a, b);

    /// <summary>A constant NaN that is chosen because a condition is false is the formula's "no crossing".</summary>
    public static Witness Select(Witness mask, Witness a, Witness b)
    {
        var chosen = mask.Holds ? a : b;
        if (!double.IsNaN(chosen.Value) || chosen.Loss != None) return chosen;
        return chosen with { Loss = mask.Loss == None ? Outcome.Outside : mask.Loss };
    }

    /// <summary>A result. If it is not finite, it keeps the loss of its operands; if they have none, it gets its own.</summary>
    private static Witness Result(double value, Witness a, Witness b, Outcome own = Outcome.NoNumber) =>
        new(value, double.IsFinite(value) ? None : Earlier(a, b) is not None and var loss ? loss : own);

    private static Witness Mask(bool holds, Witness a, Witness b)
    {
        if (holds || !(double.IsNaN(a.Value) || double.IsNaN(b.Value))) return new(holds ? 1 : 0, None);
        return new(0, Earlier(a, b) is not None and var loss ? loss : Outcome.NoNumber);
    }

    private static Outcome Earlier(Witness a, Witness b) => a.Loss != None ? a.Loss : b.Loss;
}
