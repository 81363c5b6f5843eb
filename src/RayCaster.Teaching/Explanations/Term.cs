namespace RayCaster.Teaching.Explanations;

/// <summary>How a number was computed.</summary>
internal enum Operation
{
    Constant, Name,
    Add, Subtract, Negate, Multiply, Divide,
    Less, Greater, LessOrEqual, GreaterOrEqual, And, Or,
    SquareRoot, Min, Max,
    Select, If,
}

/// <summary>A number and what it was computed from: a formula with its numbers, as a tree.</summary>
/// <param name="value">The result; for a comparison 1 for true and 0 for false.</param>
/// <param name="a">The first operand; for a choice the mask.</param>
internal sealed class Term(Operation operation, double value, Term? a = null, Term? b = null, Term? c = null)
{
    public Operation Operation => operation;

    public double Value => value;

    public Term A => a!;

    public Term B => b!;

    public bool HasB => b is not null;

    public Term C => c!;

    /// <summary>The name and the formula of a step; null for other terms.</summary>
    public Binding? Name { get; init; }

    /// <summary>A step's name in a sentence: L, or L.x for a vector's coordinate; null for other terms.</summary>
    public string? Label => Name is null ? null : Name.Terms.Length == 1 ? Name.Text : $"{Name.Text}.{"xyz"[Array.IndexOf(Name.Terms, this)]}";

    /// <summary>Whether it is the result of a test, true or false, or a name for one.</summary>
    public bool IsTest => operation is >= Operation.Less and <= Operation.Or || (operation is Operation.Name && A.IsTest);

    /// <summary>Whether it is written as its value alone.</summary>
    public bool IsLeaf => operation is Operation.Name or Operation.Constant;

    /// <summary>The length of the written term, which may be more than an int holds; a step counts as its name, a choice as the chosen
    /// operand.</summary>
    public double Size { get; } = operation switch
    {
        Operation.Name or Operation.Constant => 1,
        Operation.Select => a!.Value != 0 ? b!.Size : c!.Size,
        Operation.If => b!.Size,
        _ => 1 + (a?.Size ?? 0) + (b?.Size ?? 0),
    };

    /// <summary>A choice's chosen operand; other terms themselves. For "a crossing here, if …" the crossing, even if the test failed.</summary>
    public Term Chosen => operation switch
    {
        Operation.Select => (A.Value != 0 ? B : C).Chosen,
        Operation.If => B.Chosen,
        _ => this,
    };

    /// <summary>The operands in the order of the computation, without those that a choice did not choose.</summary>
    public IEnumerable<Term> Parts =>
        operation is Operation.Select ? [A, A.Value != 0 ? B : C] : ((Term?[])[a, b]).OfType<Term>();
}

/// <summary>The name of a step, shared by the three coordinates of a vector.</summary>
internal sealed class Binding
{
    private static long count;

    /// <param name="name">As on the slide.</param>
    /// <param name="formula">As in the code; empty for given numbers like the ray's.</param>
    /// <param name="values">What gets the name: a number, or the three of a vector.</param>
    public Binding(string name, string formula, params Term[] values)
    {
        (Text, Formula) = (name, Notation.Format(formula));
        Terms = Array.ConvertAll(values, value => new Term(Operation.Name, value.Value, value) { Name = this });
    }

    /// <summary>A number that grows in the order in which steps are computed.</summary>
    public long Number { get; } = Interlocked.Increment(ref count);

    public string Text { get; }

    /// <summary>In the notation of the slides; empty for given numbers.</summary>
    public string Formula { get; }

    /// <summary>The values under this name.</summary>
    public Term[] Terms { get; }
}
