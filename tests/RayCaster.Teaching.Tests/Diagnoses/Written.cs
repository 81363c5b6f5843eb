namespace RayCaster.Teaching.Tests.Diagnoses;

/// <summary>Mistakes that the catalogue does not have, as Mistakes.txt has its own.</summary>
internal static class Written
{
    /// <summary>The mistake of these formulas.</summary>
    public static Mistake As(string formulas) =>
        new("written", "", formulas, new("", "", ""), [.. WrittenChange.Read(formulas)], isWithinRounding: false);
}
