namespace RayCaster.Teaching.Explanations;

/// <summary>Why a formula gives NaN: the test that failed, or the operation without a result, with its numbers.</summary>
internal static class NaNReason
{
    /// <summary>The reasons, from the derivation of a crossing that is NaN.</summary>
    public static string IsNoNumber(Term term) => string.Join("; ", Find(term).Distinct());

    private static IEnumerable<string> Find(Term term) => !RuntimeHelpers.TryEnsureSufficientExecutionStack() ? [] : term.Operation switch
    {
        Operation.If when term.A.Value == 0 => FindFailure(term.A),
        Operation.Constant => ["the formula gives NaN"],
        _ => term.Parts.FirstOrDefault(part => double.IsNaN(part.Value)) is { } part ? Find(part)
            : [$"{new TermText().Write(term)} is no number"],
    };

    private static IEnumerable<string> FindFailure(Term mask, string? formula = null) => mask.Operation switch
    {
        Operation.Name => FindFailure(mask.A, mask.Name!.Formula),
        Operation.And or Operation.Or => mask.Parts.Where(part => part.Value == 0).SelectMany(part => FindFailure(part)),
        Operation.Less or Operation.Greater or Operation.LessOrEqual or Operation.GreaterOrEqual =>
            double.IsNaN(mask.A.Value) ? Find(mask.A) : double.IsNaN(mask.B.Value) ? Find(mask.B) : [Failure(mask, formula)],
        _ => [formula is null ? "a test of the formula fails" : $"{formula} is false"],
    };

    private static string Failure(Term comparison, string? formula)
    {
        var (left, right) = Digits.Apart(comparison.A.Value, comparison.B.Value);
        var sign = TermText.Comparison(comparison.Operation);
        var working = new TermText().Write(comparison.A);
        var source = formula is not null ? $"{formula}: "
            : comparison.A.Chosen.Label is { } name ? $"{name} = "
            : working != left ? $"{working} = "
            : "";
        return $"{source}{left} {sign} {right} is false";
    }
}
