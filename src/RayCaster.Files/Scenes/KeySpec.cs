namespace RayCaster.Files;

internal enum KeyKind
{
    Number,
    Whole,
    Vector,
    Vectors,
    Faces,
    Direction,
    Factors,
    Color,
    Text,
    FileName,
    Texts,
    Choice,
    Object,
    Objects,
}

/// <summary>A key of an object in a scene file, described by the code that reads it. The editors' schema is made from these.</summary>
/// <param name="Default">The value if the key is left out; null for none.</param>
internal sealed record KeySpec(string Name, KeyKind Kind, string Meaning, bool IsRequired, object? Default = null)
{
    public Limits Limits { get; init; } = Limits.None;

    public string[] Choices { get; init; } = [];

    public IReadOnlyList<KeySpec> Members { get; init; } = [];
}

/// <summary>Which numbers a key may have.</summary>
/// <param name="IsOpen">Whether the limits themselves are refused.</param>
internal sealed record Limits(double Least, double Most, bool IsOpen, bool IsZeroRefused = false)
{
    public static readonly Limits None = new(double.NegativeInfinity, double.PositiveInfinity, false);
    public static readonly Limits Positive = new(0, double.PositiveInfinity, true);
    public static readonly Limits NotNegative = new(0, double.PositiveInfinity, false);
    public static readonly Limits NotZero = None with { IsZeroRefused = true };
    public static readonly Limits Coordinate = From(-MeshPlacement.MaxCoordinate, MeshPlacement.MaxCoordinate);

    /// <summary>Numbers between two limits, which are excluded.</summary>
    public static Limits Between(double least, double most) => new(least, most, true);

    /// <summary>Numbers between two limits, which are included.</summary>
    public static Limits From(double least, double most) => new(least, most, false);

    /// <summary>The words of a message after "must be".</summary>
    public string Words =>
        this == None ? "a number"
        : this == Positive ? "greater than 0"
        : this == NotNegative ? "at least 0"
        : this == NotZero ? "other than 0"
        : this == Coordinate ? "from -1e100 to 1e100"
        : FormattableString.Invariant(IsOpen ? $"greater than {Least} and less than {Most}" : (FormattableString)$"from {Least} to {Most}");

    public bool Allow(double number) =>
        (IsOpen ? number > Least && number < Most : number >= Least && number <= Most) && !(IsZeroRefused && number == 0);
}
