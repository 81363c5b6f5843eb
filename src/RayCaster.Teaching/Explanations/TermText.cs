namespace RayCaster.Teaching.Explanations;

/// <summary>
/// Writes a formula with its numbers; named steps are written as their values. Three terms of the same form are written as a vector,
/// (20, 0, 0) + 15 · (−1, 0, 0), and a sum of three products as a dot product.
/// </summary>
/// <param name="known">Values that the reader has seen already; a part with such a value is written as the value.</param>
internal sealed class TermText(HashSet<double>? known = null)
{
    // An operator with higher precedence has a higher rank.
    private const int Condition = 0, Sum = 1, Product = 2, Sign = 3, Whole = 4;

    /// <summary>Longer parts are written as their values: a formula without named steps may become very long.</summary>
    private const int LargestPart = 60;

    /// <summary>The formula of a number or a vector, with its numbers; for a step, the formula behind its name.</summary>
    public string Write(params IReadOnlyList<Term> terms)
    {
        var formula = terms is [var x, var y, var z] ? new VectorTerm(x, y, z) : new VectorTerm(terms[0]);
        return Text(formula.Is(Operation.Name) ? formula.A : formula, Condition, leads: true, isRoot: true);
    }

    /// <param name="rank">The least rank that needs no brackets here.</param>
    /// <param name="leads">Whether it begins the formula or a bracket; elsewhere a negative number needs brackets.</param>
    private string Text(VectorTerm term, int rank, bool leads, bool isRoot = false)
    {
        if (term.IsLeaf || (!isRoot && (term.IsLong || (term.IsOne && known?.Contains(term.X.Value) == true))))
            return term.IsOne ? Number(term.X.Value, leads) : Digits.Format(new Vector3(term.X.Value, term.Y.Value, term.Z.Value));
        if (DotProduct(term) is var (a, b)) return Infix(a, " · ", b, Product, rank, leads);
        if (!term.IsOfOneShape) return $"({Inner(new(term.X))}, {Inner(new(term.Y))}, {Inner(new(term.Z))})";
        return term.X.Operation switch
        {
            Operation.Add => Infix(term.A, " + ", term.B, Sum, rank, leads),
            Operation.Subtract => Infix(term.A, " − ", term.B, Sum, rank, leads),
            Operation.Multiply => Infix(term.A, " · ", term.B, Product, rank, leads),
            Operation.Divide => Infix(term.A, " / ", term.B, Product, rank, leads),
            Operation.Negate => Bracketed($"−{Text(term.A, Whole, leads: false)}", leads ? Sign : Condition, Math.Max(rank, Sum)),
            Operation.SquareRoot when DotProduct(term.A) is var (v, w) && v.Is(w) => $"|{Inner(v)}|",
            Operation.SquareRoot => $"√({Inner(term.A)})",
            Operation.Min => $"min({Inner(term.A)}, {Inner(term.B)})",
            Operation.Max => $"max({Inner(term.A)}, {Inner(term.B)})",
            Operation.And => $"({Inner(term.A)} and {Inner(term.B)})",
            Operation.Or => $"({Inner(term.A)} or {Inner(term.B)})",
            var comparison => $"{Inner(term.A)} {Comparison(comparison)} {Inner(term.B)}",
        };
    }

    public static string Comparison(Operation operation) => operation switch
    {
        Operation.Less => "<",
        Operation.Greater => ">",
        Operation.LessOrEqual => "≤",
        _ => "≥",
    };

    private string Inner(VectorTerm term) => Text(term, Condition, leads: true);

    private string Infix(VectorTerm left, string sign, VectorTerm right, int own, int rank, bool leads) =>
        Bracketed(Text(left, own, leads || own < rank) + sign + Text(right, own + 1, leads: false), own, rank);

    private static string Bracketed(string text, int own, int rank) => own < rank ? $"({text})" : text;

    private static string Number(double value, bool leads)
    {
        var text = Digits.Format(value);
        return text.StartsWith('−') && !leads ? $"({text})" : text;
    }

    private static (VectorTerm A, VectorTerm B)? DotProduct(VectorTerm sum)
    {
        if (!sum.IsOne || sum.X is not { Operation: Operation.Add, A: { Operation: Operation.Add } first, B: var z }) return null;
        var products = new VectorTerm(first.A, first.B, z);
        if (!products.Is(Operation.Multiply)) return null;
        return products.A.IsVector && products.B.IsVector ? (products.A, products.B) : null;
    }

    /// <summary>The coordinates of a vector, or one number three times; of choices the chosen operands.</summary>
    private readonly struct VectorTerm(Term x, Term y, Term z)
    {
        public VectorTerm(Term one) : this(one, one, one) { }

        public Term X { get; } = x.Chosen;

        public Term Y { get; } = y.Chosen;

        public Term Z { get; } = z.Chosen;

        public VectorTerm A => new(X.A, Y.A, Z.A);

        public VectorTerm B => new(X.B, Y.B, Z.B);

        public bool IsOne => ReferenceEquals(X, Y) && ReferenceEquals(Y, Z);

        public bool IsAlike => X.Operation == Y.Operation && Y.Operation == Z.Operation;

        public bool IsLeaf => X.IsLeaf && Y.IsLeaf && Z.IsLeaf;

        public bool IsLong => Math.Max(X.Size, Math.Max(Y.Size, Z.Size)) > LargestPart;

        /// <summary>Whether the three can be written as one formula of vectors.</summary>
        public bool IsOfOneShape => IsOne || IsLeaf || (IsAlike && A.IsOfOneShape && (!X.HasB || B.IsOfOneShape));

        /// <summary>Whether the three belong together, as the code wrote them, and differ.</summary>
        public bool IsVector => !IsOne && IsAlike && X.Operation switch
        {
            Operation.Constant => true,
            Operation.Name => X.Name == Y.Name && Y.Name == Z.Name,
            Operation.Negate => A.IsVector,
            Operation.Add or Operation.Subtract => A.IsVector && B.IsVector,
            Operation.Multiply or Operation.Divide => A.IsVector != B.IsVector && (A.IsOne || B.IsOne),
            _ => false,
        };

        public bool Is(Operation operation) => IsAlike && X.Operation == operation;

        public bool Is(VectorTerm other) => (X, Y, Z) == (other.X, other.Y, other.Z);
    }
}
