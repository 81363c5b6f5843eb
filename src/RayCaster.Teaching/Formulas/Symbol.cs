namespace RayCaster.Teaching.Formulas;

/// <summary>A name in a formula.</summary>
/// <param name="Place">Where its value is kept.</param>
/// <param name="Bit">Its bit in a set of names; 0 for a parameter of a function, which only its own body can read.</param>
internal sealed record Symbol(string Text, int Place, UInt128 Bit)
{
    /// <summary>How many names the steps may have together.</summary>
    public const int Max = 128;

    private static readonly Dictionary<string, Symbol> known = [];

    /// <summary>The symbol of a name; one for all steps.</summary>
    public static Symbol From(string text)
    {
        lock (known)
        {
            if (known.TryGetValue(text, out var symbol)) return symbol;
            if (known.Count == Max) throw new InvalidOperationException($"More than {Max} names in the formulas.");
            return known[text] = new(text, known.Count, UInt128.One << known.Count);
        }
    }

    public static Symbol Parameter(string text, int place) => new(text, place, 0);
}
