namespace RayCaster.Teaching.Explanations;

/// <summary>
/// A number that records how it was computed. A formula over this type explains a pixel: it is the same code that draws, and the values equal
/// those of <see cref="Scalar"/> to the bit.
/// </summary>
internal readonly struct Derivation : IReal<Derivation>
{
    private readonly Term? term;

    private Derivation(Term term) => this.term = term;

    private Derivation(Operation operation, double value, params ReadOnlySpan<Derivation> from) : this(new Term(operation, value,
        from[0].Term, from.Length > 1 ? from[1].Term : null, from.Length > 2 ? from[2].Term : null))
    {
    }

    public Term Term => term ?? new(Operation.Constant, 0);

    public double Value => term?.Value ?? 0;

    public static implicit operator Derivation(double value) => new(new Term(Operation.Constant, value));

    public static Derivation operator +(Derivation a, Derivation b) => new(Operation.Add, a.Value + b.Value, a, b);

    public static Derivation operator -(Derivation a, Derivation b) => new(Operation.Subtract, a.Value - b.Value, a, b);

    public static Derivation operator -(Derivation a) => new(Operation.Negate, -a.Value, a);

    public static Derivation operator *(Derivation a, Derivation b) => new(Operation.Multiply, a.Value * b.Value, a, b);

    public static Derivation operator /(Derivation a, Derivation b) => new(Operation.Divide, a.Value / b.Value, a, b);

    public static Derivation operator <(Derivation a, Derivation b) => new(Operation.Less, Mask(a.Value < b.Value), a, b);

    public static Derivation operator >(Derivation a, Derivation b) => new(Operation.Greater, Mask(a.Value > b.Value), a, b);

    public static Derivation operator <=(Derivation a, Derivation b) => new(Operation.LessOrEqual, Mask(a.Value <= b.Value), a, b);

    public static Derivation operator >=(Derivation a, Derivation b) => new(Operation.GreaterOrEqual, Mask(a.Value >= b.Value), a, b);

    public static Derivation operator &(Derivation a, Derivation b) => new(Operation.And, Mask(a.Value != 0 && b.Value != 0), a, b);

    public static Derivation operator |(Derivation a, Derivation b) => new(Operation.Or, Mask(a.Value != 0 || b.Value != 0), a, b);

    public static Derivation Sqrt(Derivation x) => new(Operation.SquareRoot, Math.Sqrt(x.Value), x);

    public static Derivation Min(Derivation a, Derivation b) => new(Operation.Min, Math.Min(a.Value, b.Value), a, b);

    public static Derivation Max(Derivation a, Derivation b) => new(Operation.Max, Math.Max(a.Value, b.Value), a, b);

    public static Derivation Select(Derivation mask, Derivation a, Derivation b) =>
        new(Operation.Select, mask.Value != 0 ? a.Value : b.Value, mask, a, b);

    public static Derivation If(Derivation mask, Derivation value) =>
        new(Operation.If, mask.Value != 0 ? value.Value : double.NaN, mask, value);

    public static Derivation Named(Derivation value, string name, string formula) => new(new Binding(name, formula, value.Term).Terms[0]);

    public static Vector3<Derivation> Named(Vector3<Derivation> value, string name, string formula)
    {
        var terms = new Binding(name, formula, value.X.Term, value.Y.Term, value.Z.Term).Terms;
        return new(new(terms[0]), new(terms[1]), new(terms[2]));
    }

    private static double Mask(bool holds) => holds ? 1 : 0;
}
