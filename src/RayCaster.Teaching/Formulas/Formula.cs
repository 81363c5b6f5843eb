namespace RayCaster.Teaching.Formulas;

/// <summary>A line of a step: a name and what it is.</summary>
/// <param name="Parameters">Those of a function.</param>
internal sealed record Formula(Symbol Name, Expression Right, ImmutableArray<Symbol> Parameters)
{
    /// <summary>The names of the crossings of a shape, and of the condition under which it has them.</summary>
    public static readonly Symbol Near = Symbol.From("first hit"), Far = Symbol.From("second hit"), When = Symbol.From("hit");

    /// <summary>What only mistakes have. In a rule, of the first crossing: whether the ray ends there with the background, and whether the second
    /// one is tried if the first does not count. In the file: whether a pixel is written, and whether the sides are swapped.</summary>
    public static readonly Symbol Ends = Symbol.From("ends"), Second = Symbol.From("second"), Written = Symbol.From("written"),
        Turned = Symbol.From("turned");

    /// <summary>What it computes, as a reader calls it.</summary>
    public string Computed => Name == Near || Name == Far ? "t" : Name.Text;

    public override string ToString() => Name == When ? $"hit if {Right}"
        : Name == Near || Name == Far ? $"t = {Right}"
        : Parameters.IsEmpty ? $"{Name.Text} = {Right}"
        : $"{Name.Text}({string.Join(", ", Parameters.Select(parameter => parameter.Text))}) = {Right}";
}
