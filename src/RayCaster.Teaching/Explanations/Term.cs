namespace RayCaster.Teaching;

/// <summary>How a number came about.</summary>
internal enum Operation
{
    Constant, Name,
    Add, Subtract, Negate, Multiply, Divide,
    Less, Greater, LessOrEqual, GreaterOrEqual, And, Or,
    SquareRoot, Min, Max,
    Select, If, Instead,
}

/// <summary>A number and what it was computed from: a formula with its numbers, as a tree.</summary>
/// <param name="operation">What was done.</param>
/// <param name="value">What came out; of a comparison 1 for true and 0 for false.</param>
/// <param name="a">The first operand; of a choice the mask.</param>
/// <param name="b">The second operand.</param>
/// <param name="c">The third operand.</param>
internal sealed class Term(Operation operation, double value, Term? a = null, Term? b = null, Term? c = null)
{
    private const int Huge = 1_000_000;

    /// <summary>What was done.</summary>
    public Operation Operation => operation;

    /// <summary>What came out.</summary>
    public double Value => value;

    /// <summary>The first operand; of a choice the mask.</summary>
    public Term A => a!;

    /// <summary>The second operand.</summary>
    public Term B => b!;

    /// <summary>Whether there is a second operand.</summary>
    public bool HasB => b is not null;

    /// <summary>The third operand.</summary>
    public Term C => c!;

    /// <summary>The name and the source text of a step; null for what has none.</summary>
    public StepName? Step { get; init; }

    /// <summary>What a step is called in a sentence: L, or L.x for a vector's coordinate; null for what has no name.</summary>
    public string? Label => Step is null ? null : Step.Terms.Length == 1 ? Step.Name : $"{Step.Name}.{"xyz"[Array.IndexOf(Step.Terms, this)]}";

    /// <summary>Whether it is the answer of a test, true or false, or a name for one.</summary>
    public bool IsTest => operation is >= Operation.Less and <= Operation.Or || (operation is Operation.Name && A.IsTest);

    /// <summary>How long the term is written down; a step stands for itself, a choice for what it chose.</summary>
    public int Size { get; } = operation switch
    {
        Operation.Name or Operation.Constant => 1,
        Operation.Select => a!.Value != 0 ? b!.Size : c!.Size,
        Operation.If => b!.Size,
        Operation.Instead => double.IsNaN(a!.Value) ? b!.Size : a.Size,
        _ => Math.Min(Huge, 1 + (a?.Size ?? 0) + (b?.Size ?? 0)),
    };

    /// <summary>What a choice chose; any other term itself. Of "a crossing here, if …" the crossing, whether or not.</summary>
    public Term Chosen => operation switch
    {
        Operation.Select => (A.Value != 0 ? B : C).Chosen,
        Operation.If => B.Chosen,
        Operation.Instead => (double.IsNaN(A.Value) ? B : A).Chosen,
        _ => this,
    };

    /// <summary>What it was computed from, in the order in which it was computed; what a choice left out was not.</summary>
    public IEnumerable<Term> Parts
    {
        get
        {
            if (a is not null) yield return a;
            if (b is not null && (operation != Operation.Select || A.Value != 0)) yield return b;
            if (c is not null && (operation != Operation.Select || A.Value == 0)) yield return c;
        }
    }
}

/// <summary>The name of a step, shared by the three coordinates of a vector.</summary>
/// <param name="name">As on the slide.</param>
/// <param name="formula">As in the code; empty for what is given, as the ray is.</param>
internal sealed class StepName(string name, string formula)
{
    private static long count;

    /// <summary>Which of all steps it is: those of one formula are numbered in the order in which they are computed.</summary>
    public long Number { get; } = Interlocked.Increment(ref count);

    /// <summary>As on the slide.</summary>
    public string Name => name;

    /// <summary>As in the code, on one line and without the brackets around it.</summary>
    public string Formula { get; } = Tidy(formula);

    /// <summary>The named number, or the three of a vector.</summary>
    public Term[] Terms { get; set; } = [];

    private static string Tidy(string formula)
    {
        var text = string.Join(' ', formula.Split((char[]?)null, StringSplitOptions.RemoveEmptyEntries));
        return text.StartsWith('(') && ClosingOf(text) == text.Length - 1 ? Tidy(text[1..^1]) : text;
    }

    private static int ClosingOf(string text)
    {
        var depth = 0;
        for (var i = 0; i < text.Length; i++)
        {
            if (text[i] == '(') depth++;
            if (text[i] == ')' && --depth == 0) return i;
        }
        return -1;
    }
}
