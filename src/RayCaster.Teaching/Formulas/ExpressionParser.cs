namespace RayCaster.Teaching.Formulas;

/// <summary>Reads an expression in the slides' notation: L·d, a × b, |T − P|, √(R² − D2), t &gt; bias and z ≤ zFar.</summary>
/// <param name="scope">The names that may be read.</param>
/// <param name="allUnits">Whether units may differ where operands are added or compared: in a formula that somebody writes by mistake.</param>
/// <remarks>A Pratt parser: an operand, then infix operators as long as they bind more tightly than what stands before.</remarks>
internal sealed class ExpressionParser(string text, IReadOnlyDictionary<string, Expression> scope, bool allUnits = false)
{
    private static readonly Dictionary<string, Operator> infix = Enum.GetValues<Operator>().Where(op => FormulaText.Infix(op).Strength > 0)
        .ToDictionary(op => FormulaText.Infix(op).Sign.Replace('−', '-'));

    private static readonly Dictionary<string, Operator> functions = Enum.GetValues<Operator>().Where(op => op >= Operator.Abs)
        .ToDictionary(op => op.ToString().ToLowerInvariant());

    private readonly List<string> tokens = Tokens(text);
    private int next;

    /// <summary>The whole text as one expression.</summary>
    public Expression Parse()
    {
        var expression = ParseOperation(0);
        return next == tokens.Count ? expression : throw new FormatException($"'{tokens[next]}' after the end of an expression");
    }

    private static List<string> Tokens(string text)
    {
        List<string> tokens = [];
        for (var i = 0; i < text.Length;)
        {
            var end = i + 1;
            if (text[i] == '=' && end < text.Length && text[end] == '=') end++;
            if (char.IsLetterOrDigit(text[i]) && text[i] != '²')
                while (end < text.Length
                    && (char.IsLetterOrDigit(text[end]) || text[end] == '_' || (text[end] == '.' && char.IsDigit(text[i])))) end++;
            if (text[i] != ' ') tokens.Add(text[i..end] is "−" ? "-" : text[i..end]);
            i = end;
        }
        return tokens;
    }

    private Expression ParseOperation(int least)
    {
        var left = ParseOperand();
        while (next < tokens.Count)
        {
            var sign = tokens[next];
            var strength = sign == "×" ? FormulaText.Product : infix.TryGetValue(sign, out var op) ? FormulaText.Infix(op).Strength : 0;
            if (strength <= least) break;
            next++;
            var right = ParseOperation(strength);
            var areVectors = (left.Dimension.Kind, right.Dimension.Kind) == (ValueKind.Vector, ValueKind.Vector);
            left = Checked(sign switch
            {
                "×" => Expression.Call("cross", left, right),
                "·" when areVectors => Expression.Call("dot", left, right),
                _ => Expression.Create(infix[sign], left, right),
            }, sign);
        }
        return left;
    }

    private Expression ParseOperand()
    {
        var operand = ParsePrefixed();
        while (next < tokens.Count && tokens[next] is "." or "²")
        {
            if (tokens[next++] == "²") operand = Checked(Expression.Create(Operator.Multiply, operand, operand), "²");
            else operand = Checked(Expression.Create(Take() switch
            {
                "x" => Operator.X,
                "y" => Operator.Y,
                "z" => Operator.Z,
                var other => throw new FormatException($"'.{other}'; a vector has .x, .y and .z"),
            }, operand), ".");
        }
        return operand;
    }

    private Expression ParsePrefixed()
    {
        var token = Take();
        if (token == "-") return Checked(Expression.Create(Operator.Negate, ParseOperation(FormulaText.Product)), token);
        if (token == "not") return Checked(Expression.Create(Operator.Not, ParseOperand()), token);
        if (token == "√") return Checked(Expression.Create(Operator.Sqrt, ParseOperand()), token);
        if (token == "|")
        {
            var inner = ParseOperation(0);
            Expect("|");
            return Checked(
                inner.Dimension.Kind == ValueKind.Vector ? Expression.Call("length", inner) : Expression.Create(Operator.Abs, inner), token);
        }
        if (token == "(")
        {
            var list = ParseList(token, ")");
            return list.Count == 1 ? list[0] : Checked(Expression.Create(Operator.Vector, [.. list]), "(x, y, z)");
        }
        if (double.TryParse(token, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var number)) return Expression.Number(number);
        if (next < tokens.Count && tokens[next] == "(")
        {
            next++;
            var operands = ParseList(token, ")");
            var isOperator = functions.TryGetValue(token, out var op);
            return Checked(isOperator ? Expression.Create(op, [.. operands]) : Expression.Call(token, [.. operands]), token);
        }
        return scope.TryGetValue(token, out var name) ? name : throw new FormatException($"unknown name '{token}'");
    }

    private List<Expression> ParseList(string before, string end)
    {
        List<Expression> list = [];
        while (true)
        {
            list.Add(ParseOperation(0));
            var token = Take();
            if (token == end) return list;
            if (token != ",") throw new FormatException($"'{token}' in what follows '{before}'");
        }
    }

    private string Take() => next < tokens.Count ? tokens[next++] : throw new FormatException("the expression ends too early");

    private void Expect(string token)
    {
        var found = Take();
        if (found != token) throw new FormatException($"'{found}' where '{token}' is expected");
    }

    private Expression Checked(Expression? made, string sign) => made switch
    {
        null => throw new FormatException($"'{sign}' does not take such operands"),
        { IsConsistent: false } when !allUnits => throw new FormatException($"the units on both sides of '{sign}' differ: "
            + string.Join(" and ", made.Operands.Select(operand => $"{operand} is {operand.Dimension}"))),
        _ => made,
    };
}
