namespace RayCaster.Teaching.Changes;

/// <summary>What somebody writes instead of an expression: a rule of Slips.txt, for one kind of value of each letter.</summary>
/// <param name="Slip">The place in the text: rules of the same slip have the same.</param>
/// <param name="More">What it costs more than its operator.</param>
internal sealed record RewriteRule(MutationOperator Mutation, Expression Left, Expression Right, double More, (int Line, int Choice) Slip)
{
    /// <summary>A letter for a name alone, and one for a number as it is written.</summary>
    public const string OneName = "name", OneNumber = "number";

    /// <summary>The letters that stand for expressions, and the kinds of value that they may have.</summary>
    public static IReadOnlyDictionary<string, ImmutableArray<ValueKind>> Letters { get; } = new Dictionary<string, ImmutableArray<ValueKind>>
    {
        ["a"] = [ValueKind.Number, ValueKind.Vector],
        ["b"] = [ValueKind.Number, ValueKind.Vector],
        ["c"] = [ValueKind.Number, ValueKind.Vector],
        ["n"] = [ValueKind.Number],
        [OneName] = [ValueKind.Number],
        [OneNumber] = [ValueKind.Number],
        ["u"] = [ValueKind.Vector],
        ["v"] = [ValueKind.Vector],
        ["p"] = [ValueKind.Truth],
        ["q"] = [ValueKind.Truth],
    };

    /// <summary>Whether it puts something around what is right.</summary>
    public bool IsAround { get; } = Has(Right, $"{Left}");

    private bool IsOfNumbers => Left.Operator == Operator.Number || Left.Symbol?.Text == OneNumber;

    /// <summary>A letter as an expression of a kind. Its symbol is no name of a formula.</summary>
    public static Expression Letter(string letter, ValueKind kind) => Expression.Name(Symbol.Parameter(letter, -1), new(kind));

    /// <summary>What is written instead of an expression; null if it does not fit, or if that is of another kind.</summary>
    public Expression? Apply(Expression e)
    {
        if (!IsLetter(Left) && e.Operator != Left.Operator) return null; // of most: there are thousands
        var isNumber = e.Operator == Operator.Number;
        var parts = new Dictionary<string, Expression>();
        if (isNumber != IsOfNumbers || !Matches(Left, e, parts) || Filled(Right, parts) is not { } written) return null;
        if (written.Dimension.Kind != e.Dimension.Kind) return null;
        return isNumber ? Expression.Number(ValueOf(written)) : written;
    }

    private static bool IsLetter(Expression e) => e is { Operator: Operator.Name, Symbol.Place: < 0 };

    private static bool Has(Expression e, string part) => e.ToString() == part || e.Operands.Any(operand => Has(operand, part));

    private static bool Matches(Expression pattern, Expression e, Dictionary<string, Expression> parts)
    {
        if (IsLetter(pattern))
        {
            var letter = pattern.Symbol!.Text;
            if (parts.TryGetValue(letter, out var same)) return same.ToString() == e.ToString();
            parts[letter] = e;
            return e.Dimension.Kind == pattern.Dimension.Kind
                && letter switch { OneName => e.Operator == Operator.Name, OneNumber => e.Operator == Operator.Number, _ => true };
        }
        if ((pattern.Operator, pattern.Symbol, pattern.Value) != (e.Operator, e.Symbol, e.Value)) return false;
        for (var i = 0; i < pattern.Operands.Length; i++)
            if (!Matches(pattern.Operands[i], e.Operands[i], parts)) return false;
        return true;
    }

    private static Expression? Filled(Expression pattern, Dictionary<string, Expression> parts)
    {
        if (IsLetter(pattern)) return parts[pattern.Symbol!.Text];
        if (pattern.Operands.IsEmpty) return pattern;
        var operands = new Expression[pattern.Operands.Length];
        for (var i = 0; i < operands.Length; i++)
        {
            if (Filled(pattern.Operands[i], parts) is not { } operand) return null;
            operands[i] = operand;
        }
        return pattern.Operator == Operator.Call ? Expression.Call(pattern.Symbol!.Text, [.. operands])
            : Expression.Create(pattern.Operator, [.. operands]);
    }

    /// <summary>A number that is written instead of another one, as in 2·number.</summary>
    private static double ValueOf(Expression e) => e.Operator switch
    {
        Operator.Number => e.Value,
        Operator.Negate => 0 - ValueOf(e.Operands[0]),
        Operator.Multiply => ValueOf(e.Operands[0]) * ValueOf(e.Operands[1]),
        Operator.Divide => ValueOf(e.Operands[0]) / ValueOf(e.Operands[1]),
        _ => throw new NotSupportedException($"{e} in a rule for numbers"),
    };
}
