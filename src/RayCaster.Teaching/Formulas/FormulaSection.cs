namespace RayCaster.Teaching;

/// <summary>What a section's formulas are for, in the order of the way of the data.</summary>
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

    public override string ToString() => Name == When ? $"hits when {Right}"
        : Parameters.IsEmpty ? $"{Name.Text} = {Right}"
        : $"{Name.Text}({string.Join(", ", Parameters.Select(parameter => parameter.Text))}) = {Right}";
}

/// <summary>The formulas of one step, in one right style or with an edit.</summary>
/// <param name="Style">The way in which it is written; empty for the only one.</param>
/// <param name="Slide">The slide's title.</param>
/// <param name="Scope">The names that its first formula can read.</param>
internal sealed record FormulaSection(
    SectionKind Kind, string Style, string Slide, IReadOnlyDictionary<string, Expression> Scope, ImmutableArray<Formula> Formulas)
{
    /// <summary>All that its formulas read.</summary>
    public UInt128 Reads { get; } = Formulas.Aggregate(UInt128.Zero, (all, formula) => all | formula.Right.Reads);

    /// <summary>As its text calls it.</summary>
    public string Name => $"{Kind.ToString().ToLowerInvariant()} {Style}".TrimEnd();

    public Formula? Find(Symbol name) => Formulas.FirstOrDefault(formula => formula.Name == name);

    public FormulaSection With(int place, Expression right) =>
        this with { Formulas = Formulas.SetItem(place, Formulas[place] with { Right = right }) };
}
