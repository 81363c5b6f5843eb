namespace RayCaster.Teaching;

/// <summary>What a section's formulas are for, in pipeline order.</summary>
internal enum SectionKind
{
    Vectors,
    Camera,
    File,
    Pixel,
    Plane,
    Circle,
    Sphere,
    Aabb,
    Triangle,
    Rule,
    Light,
    Bytes,
}

/// <summary>A line of a section: a name and what it is.</summary>
/// <param name="Parameters">Those of a function.</param>
internal sealed record Formula(Symbol Name, Expression Right, ImmutableArray<Symbol> Parameters)
{
    /// <summary>The names of the crossings of a shape, and of the condition under which it has them.</summary>
    public static readonly Symbol Near = Symbol.Of("first hit"), Far = Symbol.Of("second hit"), When = Symbol.Of("hit");

    /// <summary>What it computes, as a reader calls it.</summary>
    public string Computed => Name == Near || Name == Far ? "t" : Name.Text;

    public override string ToString() => Name == When ? $"hit if {Right}"
        : Name == Near || Name == Far ? $"t = {Right}"
        : Parameters.IsEmpty ? $"{Name.Text} = {Right}"
        : $"{Name.Text}({string.Join(", ", Parameters.Select(parameter => parameter.Text))}) = {Right}";
}

/// <summary>The formulas of one step, in one right style or with an edit.</summary>
/// <param name="style">The way in which it is written; empty for the only one.</param>
/// <param name="slide">The slide's title.</param>
/// <param name="scope">The names that its first formula can read.</param>
internal sealed class FormulaSection(
    SectionKind kind, string style, string slide, IReadOnlyDictionary<string, Expression> scope, ImmutableArray<Formula> formulas)
{
    public SectionKind Kind => kind;

    public string Style => style;

    public string Slide => slide;

    public IReadOnlyDictionary<string, Expression> Scope => scope;

    public ImmutableArray<Formula> Formulas => formulas;

    /// <summary>All that its formulas read.</summary>
    public UInt128 Reads { get; } = formulas.Aggregate(UInt128.Zero, (all, formula) => all | formula.Right.Reads);

    /// <summary>As its text calls it.</summary>
    public string Name => $"{kind.ToString().ToLowerInvariant()} {style}".TrimEnd();

    /// <summary>The place of a formula; −1 if no formula has the name.</summary>
    public int Find(string name)
    {
        for (var i = 0; i < formulas.Length; i++)
            if (formulas[i].Name.Text == name) return i;
        return -1;
    }

    public bool Has(Symbol name) => formulas.Any(formula => formula.Name == name);

    public FormulaSection With(ImmutableArray<Formula> others) => new(kind, style, slide, scope, others);

    /// <summary>The same with another formula, which may read what comes before it.</summary>
    public FormulaSection With(string name, string right)
    {
        var place = Find(name);
        var names = new Dictionary<string, Expression>(scope);
        foreach (var (before, own, _) in formulas.Take(place)) names[before.Text] = Expression.Name(before, own.Quantity);
        return With(place, new ExpressionParser(right, names, allUnits: true).Parse());
    }

    public FormulaSection With(int place, Expression right) => With(formulas.SetItem(place, formulas[place] with { Right = right }));
}
