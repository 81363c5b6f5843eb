namespace RayCaster.Teaching.Formulas;

/// <summary>What an expression's value is.</summary>
internal enum ValueKind
{
    Truth,
    Number,
    Vector,
}

/// <summary>The kind and the unit of an expression.</summary>
/// <param name="Length">The power of a length: 2 for an area. A direction is a vector of power 0, a point and a displacement are of power 1.</param>
/// <param name="Measure">What else it counts: pixels or an angle; a point is measured from the origin.</param>
internal readonly record struct Dimension(ValueKind Kind, double Length = 0, Measure Measure = Measure.None)
{
    /// <summary>The words by which a step's text names units.</summary>
    public static IReadOnlyDictionary<string, Dimension> Words { get; } = new Dictionary<string, Dimension>
    {
        ["truth"] = Truth,
        ["none"] = Number,
        ["length"] = new(ValueKind.Number, 1),
        ["length²"] = new(ValueKind.Number, 2),
        ["length⁴"] = new(ValueKind.Number, 4),
        ["angle"] = new(ValueKind.Number, Measure: Measure.Angle),
        ["pixels"] = new(ValueKind.Number, Measure: Measure.Pixels),
        ["direction"] = new(ValueKind.Vector),
        ["displacement"] = new(ValueKind.Vector, 1),
        ["displacement²"] = new(ValueKind.Vector, 2),
        ["point"] = new(ValueKind.Vector, 1, Measure.Point),
    };

    public static Dimension Truth => new(ValueKind.Truth);

    /// <summary>A number without a unit.</summary>
    public static Dimension Number => new(ValueKind.Number);

    public bool IsPure => Length == 0 && Measure == Measure.None;

    /// <summary>The word for it; an edit may give it a unit that has none.</summary>
    public override string ToString()
    {
        foreach (var (word, dimension) in Words)
            if (dimension == this) return word;
        return FormattableString.Invariant($"{Kind} {Measure} length^{Length}").ToLowerInvariant();
    }
}

/// <summary>Units that are no power of a length.</summary>
internal enum Measure
{
    None,
    Angle,
    Pixels,
    Point,
}
