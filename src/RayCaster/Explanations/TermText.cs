namespace RayCaster;

/// <summary>
/// Writes a formula with its numbers put in, down to the steps that have a name. Three terms of one shape are a vector:
/// (20, 0, 0) + 15 · (−1, 0, 0) rather than three sums; three products added up are a dot product.
/// </summary>
internal static class TermText
{
    // What binds closer has the higher rank.
    private const int Condition = 0, Sum = 1, Product = 2, Sign = 3, Whole = 4;

    /// <summary>Larger parts stand as their value: a formula without named steps may repeat itself endlessly.</summary>
    private const int LargestPart = 60;

    /// <summary>A number's or a vector's formula with its numbers; a step's is what it was computed from.</summary>
    public static string Of(params IReadOnlyList<Term> terms)
    {
        var formula = terms is [var x, var y, var z] ? new Three(x, y, z) : new Three(terms[0]);
        formula = formula.Chosen;
        return Text(formula.Is(Operation.Name) ? formula.A.Chosen : formula, Condition, isRoot: true);
    }

    private static string Text(Three term, int rank, bool isRoot = false)
    {
        term = term.Chosen;
        if (term.IsOne && (term.IsLeaf || (!isRoot && term.X.Size > LargestPart))) return Number(term.X.Value, rank);
        if (DotProduct(term) is var (a, b)) return Infix(a, " · ", b, Product, rank);
        if (!term.IsOne && term.IsLeaf) return Digits.Of([term.X.Value, term.Y.Value, term.Z.Value]);
        if (!term.IsAlike) return $"({Text(new(term.X), Sum)}, {Text(new(term.Y), Sum)}, {Text(new(term.Z), Sum)})";
        return term.X.Operation switch
        {
            Operation.Add => Infix(term.A, " + ", term.B, Sum, rank),
            Operation.Subtract => Infix(term.A, " − ", term.B, Sum, rank),
            Operation.Multiply => Infix(term.A, " · ", term.B, Product, rank),
            Operation.Divide => Infix(term.A, " / ", term.B, Product, rank),
            Operation.Negate => Bracketed($"−{Text(term.A, Whole)}", Sign, rank),
            Operation.SquareRoot => $"√{Bracketed(Text(term.A, Condition), Condition, Whole)}",
            Operation.Min => $"min({Text(term.A, Sum)}, {Text(term.B, Sum)})",
            Operation.Max => $"max({Text(term.A, Sum)}, {Text(term.B, Sum)})",
            Operation.And => $"({Text(term.A, Condition)} and {Text(term.B, Condition)})",
            Operation.Or => $"({Text(term.A, Condition)} or {Text(term.B, Condition)})",
            var comparison => $"{Text(term.A, Sum)} {Comparison(comparison)} {Text(term.B, Sum)}",
        };
    }

    /// <summary>The sign of a comparison.</summary>
    public static string Comparison(Operation operation) => operation switch
    {
        Operation.Less => "<",
        Operation.Greater => ">",
        Operation.LessOrEqual => "≤",
        Operation.GreaterOrEqual => "≥",
        _ => throw new ArgumentOutOfRangeException(nameof(operation), operation, "no comparison"),
    };

    private static string Infix(Three left, string sign, Three right, int own, int rank) =>
        Bracketed(Text(left, own) + sign + Text(right, own + 1), own, rank);

    private static string Bracketed(string text, int own, int rank) => own < rank ? $"({text})" : text;

    /// <summary>A negative number on the right of a sign is put into brackets.</summary>
    private static string Number(double value, int rank) =>
        Digits.Of(value) is var text && text.StartsWith('−') && rank >= Product ? $"({text})" : text;

    private static (Three A, Three B)? DotProduct(Three sum)
    {
        if (!sum.IsOne || sum.X is not { Operation: Operation.Add, A: { Operation: Operation.Add } first, B: var z }) return null;
        var products = new Three(first.A, first.B, z);
        if (!products.Is(Operation.Multiply)) return null;
        return products.A.IsVector && products.B.IsVector ? (products.A, products.B) : null;
    }

    /// <summary>The coordinates of a vector, or one number three times.</summary>
    private readonly record struct Three(Term X, Term Y, Term Z)
    {
        public Three(Term one) : this(one, one, one) { }

        public Three A => new(X.A, Y.A, Z.A);

        public Three B => new(X.B, Y.B, Z.B);

        public Three Chosen => new(X.Chosen, Y.Chosen, Z.Chosen);

        public bool IsOne => ReferenceEquals(X, Y) && ReferenceEquals(Y, Z);

        public bool IsAlike => X.Operation == Y.Operation && Y.Operation == Z.Operation;

        public bool IsLeaf => IsLeafTerm(X) && IsLeafTerm(Y) && IsLeafTerm(Z);

        public bool Is(Operation operation) => IsAlike && X.Operation == operation;

        /// <summary>Whether the three belong together, as the code wrote them, and differ.</summary>
        public bool IsVector
        {
            get
            {
                var (x, y, z) = Chosen;
                if (new Three(x, y, z) is var chosen && (chosen.IsOne || !chosen.IsAlike)) return false;
                return x.Operation switch
                {
                    Operation.Constant => true,
                    Operation.Name => x.Step == y.Step && y.Step == z.Step,
                    Operation.Negate => chosen.A.IsVector,
                    Operation.Add or Operation.Subtract => chosen.A.IsVector && chosen.B.IsVector,
                    Operation.Multiply or Operation.Divide => chosen.A.IsVector != chosen.B.IsVector && (chosen.A.IsOne || chosen.B.IsOne),
                    _ => false,
                };
            }
        }

        private static bool IsLeafTerm(Term term) => term.Operation is Operation.Name or Operation.Constant;
    }
}
