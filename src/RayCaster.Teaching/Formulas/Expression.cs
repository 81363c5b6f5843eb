namespace RayCaster.Teaching.Formulas;

/// <summary>What an <see cref="Expression"/> does with its operands.</summary>
internal enum Operator
{
    Number,
    Name,
    X,
    Y,
    Z,
    Negate,
    Not,
    Or,
    And,
    Less,
    Greater,
    AtMost,
    AtLeast,
    Equal, // as C# compares: no slip in a right formula, but people write it
    Add,
    Subtract,
    Multiply,
    Divide,
    Vector, // of three numbers
    Call, // of dot, cross, length or normalize, which the step of vectors defines
    Sqrt,
    Abs,
    Sin,
    Cos,
    Tan,
    Atan,
    Truncate,
    Cast, // to a byte, as C# does it: 256 becomes 0
    Min,
    Max,
    Power, // of each coordinate
    Srgb, // what sRGB (IEC 61966-2-1) stores for a linear channel, of each coordinate
    If, // condition, then, else
}

/// <summary>A formula's tree; it never changes. Each node has a kind and a unit.</summary>
internal sealed class Expression
{
    private static readonly string[] functions = ["dot", "cross", "length", "normalize", "plus", "minus"]; // as the step has them

    private string? text; // thousands of edits share their parts, and are told apart by their texts

    private Expression(Operator op, Dimension dimension, ImmutableArray<Expression> operands, Symbol? symbol = null, double number = 0)
    {
        (Operator, Dimension, Operands, Symbol, Value) = (op, dimension, operands, symbol, number);
        if (op == Operator.Number) Constant = PixelValues.From(number);
        Function = Array.IndexOf(functions, (op, dimension.Kind) switch
        {
            (Operator.Call, _) => symbol!.Text,
            (Operator.Add, ValueKind.Vector) => "plus",
            (Operator.Subtract, ValueKind.Vector) => "minus",
            _ => "",
        });
        Reads = op == Operator.Name ? symbol!.Bit : Function < 0 ? 0 : Symbol.From(functions[Function]).Bit;
        foreach (var operand in operands) Reads |= operand.Reads;
    }

    public Operator Operator { get; }

    public Dimension Dimension { get; }

    public ImmutableArray<Expression> Operands { get; }

    /// <summary>The name that is read, or the function that is called.</summary>
    public Symbol? Symbol { get; }

    /// <summary>The place in the step of vectors of the function that computes it; −1 if none does.</summary>
    public int Function { get; }

    /// <summary>The number that is written.</summary>
    public double Value { get; }

    /// <summary>The same in all pixels.</summary>
    public PixelValues Constant { get; }

    /// <summary>The bits of all names and functions in it.</summary>
    public UInt128 Reads { get; }

    public static Expression Number(double value) => new(Operator.Number, Dimension.Number, [], number: value);

    public static Expression Name(Symbol symbol, Dimension dimension) => new(Operator.Name, dimension, [], symbol);

    /// <summary>A function's parameter: any vector.</summary>
    public static Expression Parameter(Symbol symbol) => Name(symbol, Dimension.Words["displacement"]);

    /// <summary>An operation; null if its operands are not of the kinds that it takes.</summary>
    public static Expression? Create(Operator op, params ImmutableArray<Expression> operands) =>
        DimensionOf(op, operands) is { } dimension ? new(op, dimension, operands) : null;

    /// <summary>The call of a function of vectors; null if its operands are no vectors.</summary>
    public static Expression? Call(string function, params ImmutableArray<Expression> operands)
    {
        if (operands.Any(operand => operand.Dimension.Kind != ValueKind.Vector)) return null;
        var length = operands.Sum(operand => operand.Dimension.Length);
        Dimension? dimension = (function, operands.Length) switch
        {
            ("dot", 2) or ("length", 1) => new(ValueKind.Number, length),
            ("cross", 2) => new(ValueKind.Vector, length),
            ("normalize", 1) => new(ValueKind.Vector),
            _ => null,
        };
        return dimension is { } known ? new(Operator.Call, known, operands, Symbol.From(function)) : null;
    }

    /// <summary>The same with another operand; null if the kinds do not fit.</summary>
    public Expression? With(int place, Expression operand)
    {
        var operands = Operands.SetItem(place, operand);
        return Operator == Operator.Call ? Call(Symbol!.Text, operands) : Create(Operator, operands);
    }

    /// <summary>This with the edits of another one, where both have edited different parts of what is right; null if they have edited the same.
    /// </summary>
    public Expression? Merged(Expression right, Expression other)
    {
        if (other.ToString() == right.ToString()) return this;
        if (ToString() == right.ToString() || ToString() == other.ToString()) return other;
        if (Wrapped(right, other) is { } mine) return mine;
        if (other.Wrapped(right, this) is { } others) return others;
        if (Operands.IsEmpty || (Operator, Symbol) != (right.Operator, right.Symbol) || (Operator, Symbol) != (other.Operator, other.Symbol))
            return null;
        var merged = this;
        for (var i = 0; i < Operands.Length && merged is not null; i++)
            merged = Operands[i].Merged(right.Operands[i], other.Operands[i]) is { } operand ? merged.With(i, operand) : null;
        return merged;
    }

    /// <summary>Where this is something around what is right, or what is right is a function of this: the same of another expression. Null if it is
    /// neither.</summary>
    private Expression? Wrapped(Expression right, Expression other)
    {
        if (Around(right, other) is { } around) return around;
        for (var i = 0; right.IsFunction && (other.Operator, other.Symbol) == (right.Operator, right.Symbol) && i < right.Operands.Length; i++)
            if (ToString() == right.Operands[i].ToString()) return other.Operands[i];
        return null;
    }

    /// <summary>This with another expression in the place of a part of it; null if it does not have that part.</summary>
    private Expression? Around(Expression part, Expression other)
    {
        if (ToString() == part.ToString()) return other;
        for (var i = 0; i < Operands.Length; i++)
            if (Operands[i].Around(part, other) is { } operand) return With(i, operand);
        return null;
    }

    private bool IsFunction => Operands.Length == 1 || Operator is Operator.Min or Operator.Max;

    /// <summary>Whether two operands have units that can be added or compared. Edits need not keep that, the slides do.</summary>
    public bool IsConsistent => Operands.All(operand => operand.IsConsistent)
        && (!(Operator is >= Operator.Less and <= Operator.Subtract or Operator.Min or Operator.Max) || Operands is not [var a, var b]
            || a.Dimension.IsPure || b.Dimension.IsPure || a.Dimension.Length == b.Dimension.Length && a.Dimension.Measure switch
            {
                Measure.Point => Operator is Operator.Subtract || b.Dimension.Measure == Measure.None,
                Measure.None => b.Dimension.Measure == Measure.None || (b.Dimension.Measure == Measure.Point && Operator == Operator.Add),
                var measure => b.Dimension.Measure == measure,
            });

    public override string ToString() => text ??= FormulaText.Format(this);

    private static Dimension? DimensionOf(Operator op, ImmutableArray<Expression> operands)
    {
        if (operands.Length != op switch
        {
            Operator.Number or Operator.Name or Operator.Call => -1,
            Operator.Vector or Operator.If => 3,
            >= Operator.Or and <= Operator.Divide or Operator.Min or Operator.Max or Operator.Power => 2,
            _ => 1,
        }) return null;
        var a = operands[0].Dimension;
        var b = operands[^1].Dimension;
        return op switch
        {
            Operator.And or Operator.Or or Operator.Not => a.Kind == ValueKind.Truth && b.Kind == ValueKind.Truth ? Dimension.Truth : null,
            Operator.If => a.Kind == ValueKind.Truth && operands[1].Dimension.Kind == b.Kind ? b : null,
            _ when a.Kind == ValueKind.Truth || b.Kind == ValueKind.Truth => null,
            Operator.X or Operator.Y or Operator.Z => a.Kind == ValueKind.Vector ? a with { Kind = ValueKind.Number, Measure = 0 } : null,
            Operator.Vector => operands.All(operand => operand.Dimension.Kind == ValueKind.Number) ? new(ValueKind.Vector, a.Length) : null,
            Operator.Negate or Operator.Abs or Operator.Truncate or Operator.Cast or Operator.Power or Operator.Srgb => a,
            Operator.Sqrt => a with { Length = a.Length / 2 },
            Operator.Sin or Operator.Cos or Operator.Tan or Operator.Atan => a.Kind == ValueKind.Number ? Dimension.Number : null,
            Operator.Multiply => a.Kind == ValueKind.Vector && b.Kind == ValueKind.Vector ? null : Product(a, b, 1),
            Operator.Divide => a.Kind == ValueKind.Number && b.Kind == ValueKind.Vector ? null : Product(a, b, -1),
            _ when a.Kind != b.Kind => null,
            >= Operator.Less and <= Operator.Equal => a.Kind == ValueKind.Number ? Dimension.Truth : null,
            Operator.Subtract when a.Measure == Measure.Point && b.Measure == Measure.Point => a with { Measure = 0 },
            Operator.Add when b.Measure == Measure.Point => b,
            _ => a.IsPure ? b with { Measure = b.Measure == Measure.Point ? 0 : b.Measure } : a,
        };
    }

    private static Dimension Product(Dimension a, Dimension b, int sign)
    {
        var kind = a.Kind == ValueKind.Vector || b.Kind == ValueKind.Vector ? ValueKind.Vector : ValueKind.Number;
        var measure = sign < 0 && a.Measure == b.Measure ? 0 : a.IsPure ? b.Measure : a.Measure; // pixels / pixels is a pure number
        return new(kind, a.Length + sign * b.Length, measure == Measure.Point ? 0 : measure);
    }
}
