namespace RayCaster.Teaching.Formulas;

/// <summary>Writes expressions in the slides' notation.</summary>
internal static class FormulaText
{
    /// <summary>How tightly each infix operator binds, and how it is written.</summary>
    public static (int Strength, string Sign) Infix(Operator op) => op switch
    {
        Operator.Or => (1, "or"),
        Operator.And => (2, "and"),
        Operator.Less => (3, "<"),
        Operator.Greater => (3, ">"),
        Operator.AtMost => (3, "≤"),
        Operator.AtLeast => (3, "≥"),
        Operator.Equal => (3, "=="),
        Operator.Add => (4, "+"),
        Operator.Subtract => (4, "−"),
        Operator.Multiply => (5, "·"),
        Operator.Divide => (5, "/"),
        _ => (0, ""),
    };

    /// <summary>How tightly × binds: as products do; and a sign before an operand.</summary>
    public const int Product = 5, Prefix = 6, Atom = 7;

    public static string Format(Expression e) => e.Operator switch
    {
        Operator.Number => e.Value.ToString("0.##########", CultureInfo.InvariantCulture),
        Operator.Name => e.Symbol!.Text,
        Operator.X or Operator.Y or Operator.Z => $"{Within(e.Operands[0], Atom)}.{e.Operator.ToString().ToLowerInvariant()}",
        Operator.Negate => "−" + Within(e.Operands[0], Prefix),
        Operator.Not => $"not {Within(e.Operands[0], Prefix)}",
        Operator.Vector => $"({List(e)})",
        Operator.Sqrt => e.Operands[0].Operands.Length == 0 ? $"√{e.Operands[0]}" : $"√({e.Operands[0]})",
        Operator.Abs => $"|{e.Operands[0]}|",
        Operator.Multiply when IsSquare(e) => Within(e.Operands[0], Atom) + "²",
        Operator.Call when e.Symbol!.Text == "length" => $"|{e.Operands[0]}|",
        Operator.Call when e.Symbol!.Text == "dot" => Infix(e, "·", Product),
        Operator.Call when e.Symbol!.Text == "cross" => Infix(e, " × ", Product),
        Operator.Call => $"{e.Symbol!.Text}({List(e)})",
        Operator.Multiply => Infix(e, "·", Product),
        var op when Infix(op) is ( > 0, _) infix => Infix(e, $" {infix.Sign} ", infix.Strength),
        var op => $"{op.ToString().ToLowerInvariant()}({List(e)})",
    };

    private static bool IsSquare(Expression e) =>
        ReferenceEquals(e.Operands[0], e.Operands[1]) || e.Operands[0].ToString() == e.Operands[1].ToString();

    private static string Infix(Expression e, string sign, int strength) =>
        Within(e.Operands[0], strength) + sign
        + Within(e.Operands[1], e.Operator is Operator.And or Operator.Or or Operator.Add ? strength : strength + 1);

    private static string List(Expression e) => string.Join(", ", e.Operands);

    private static string Within(Expression e, int least)
    {
        var strength = e.Operator switch
        {
            Operator.Negate or Operator.Not => Prefix,
            Operator.Multiply when IsSquare(e) => Prefix,
            Operator.Call => e.Symbol!.Text is "dot" or "cross" ? Product : Atom,
            var op => Infix(op) is ( > 0, _) infix ? infix.Strength : Atom,
        };
        return strength < least ? $"({e})" : e.ToString();
    }
}
